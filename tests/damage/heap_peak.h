#pragma once

#include <cstddef>

namespace marey::test {

/// Measures how many bytes of the heap are in use at most, beyond those in use at the beginning. One at a time.
class HeapPeak {
 public:
  HeapPeak();
  [[nodiscard]] std::size_t bytes() const;

 private:
  std::size_t begin_;
};

}  // namespace marey::test
