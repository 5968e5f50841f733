#include "tests/core/document/failing_allocation.h"

#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::int64_t kUnlimited = std::numeric_limits<std::int64_t>::max();
std::int64_t successes_left = kUnlimited;

void* allocate(std::size_t size) noexcept {
  if (successes_left == 0) return nullptr;
  if (successes_left != kUnlimited) --successes_left;
  return std::malloc(size == 0 ? 1 : size);
}

void* allocate_or_throw(std::size_t size) {
  void* const memory = allocate(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return allocate_or_throw(size); }
void* operator new[](std::size_t size) { return allocate_or_throw(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace marey::test {

FailingAllocation::FailingAllocation(std::int64_t successes) { successes_left = successes; }

FailingAllocation::~FailingAllocation() { successes_left = kUnlimited; }

}  // namespace marey::test
