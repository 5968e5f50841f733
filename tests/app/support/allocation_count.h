#pragma once

#include <cstddef>

namespace marey::app {

/// Counts the blocks that the program takes from the heap, ImGui's included, from its making on. One at a time.
class AllocationCount {
 public:
  AllocationCount();
  ~AllocationCount();
  AllocationCount(const AllocationCount&) = delete;
  AllocationCount& operator=(const AllocationCount&) = delete;

  [[nodiscard]] std::size_t blocks() const;
};

}  // namespace marey::app
