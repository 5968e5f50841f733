#include "tests/damage/heap_peak.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

std::size_t bytes_in_use = 0;
std::size_t most_bytes = 0;

// In front of each block stands its size.
constexpr std::size_t kFront = __STDCPP_DEFAULT_NEW_ALIGNMENT__;

void* allocate(std::size_t size) {
  void* const block = size > SIZE_MAX - kFront ? nullptr : std::malloc(size + kFront);
  if (block == nullptr) std::abort();
  std::memcpy(block, &size, sizeof size);
  bytes_in_use += size;
  most_bytes = std::max(most_bytes, bytes_in_use);
  return static_cast<char*>(block) + kFront;
}

void release(void* memory) {
  if (memory == nullptr) return;
  void* const block = static_cast<char*>(memory) - kFront;
  std::size_t size = 0;
  std::memcpy(&size, block, sizeof size);
  bytes_in_use -= size;
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
// AddressSanitizer has its own of these two; std::stable_sort calls the first.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }

namespace marey::test {

HeapPeak::HeapPeak() : begin_(bytes_in_use) { most_bytes = bytes_in_use; }

std::size_t HeapPeak::bytes() const { return most_bytes - begin_; }

}  // namespace marey::test
