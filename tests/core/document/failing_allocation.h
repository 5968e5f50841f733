#pragma once

#include <cstdint>

namespace marey::test {

/// While it lives, `new` succeeds so many times and then throws std::bad_alloc each time. One at a time.
class FailingAllocation {
 public:
  explicit FailingAllocation(std::int64_t successes);
  ~FailingAllocation();
  FailingAllocation(const FailingAllocation&) = delete;
  FailingAllocation& operator=(const FailingAllocation&) = delete;
};

}  // namespace marey::test
