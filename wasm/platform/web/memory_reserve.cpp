#include "wasm/platform/web/memory_reserve.h"

#include <cstddef>
#include <cstdlib>
#include <new>
#include <utility>

namespace marey::app {
namespace {

constexpr std::size_t kBytes = std::size_t{4} << 20;

void* reserve = nullptr;

void give_back_or_throw() {
  if (reserve == nullptr) throw std::bad_alloc();
  std::free(std::exchange(reserve, nullptr));
}

}  // namespace

MemoryReserve::MemoryReserve() {
  std::set_new_handler(give_back_or_throw);
  refill();
}

MemoryReserve::~MemoryReserve() {
  std::set_new_handler(nullptr);
  std::free(std::exchange(reserve, nullptr));
}

void MemoryReserve::refill() {
  if (reserve == nullptr) reserve = std::malloc(kBytes);
}

}  // namespace marey::app
