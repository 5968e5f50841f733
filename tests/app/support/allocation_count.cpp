#include "tests/app/support/allocation_count.h"

#include <imgui.h>

#include <cstdlib>
#include <new>

namespace {

std::size_t blocks_taken = 0;

void* take(std::size_t size) {
  ++blocks_taken;
  void* const block = std::malloc(size);
  if (block == nullptr) std::abort();
  return block;
}

}  // namespace

void* operator new(std::size_t size) { return take(size); }
void* operator new[](std::size_t size) { return take(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return take(size); }  // std::stable_sort
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return take(size); }
void operator delete(void* block) noexcept { std::free(block); }
void operator delete[](void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete[](void* block, std::size_t) noexcept { std::free(block); }

namespace marey::app {
namespace {

ImGuiMemAllocFunc former_alloc = nullptr;
ImGuiMemFreeFunc former_free = nullptr;
void* former_data = nullptr;

}  // namespace

// ImGui's own functions are malloc and free too, so that blocks may outlive the exchange.
AllocationCount::AllocationCount() {
  ImGui::GetAllocatorFunctions(&former_alloc, &former_free, &former_data);
  ImGui::SetAllocatorFunctions([](std::size_t size, void*) { return take(size); }, [](void* block, void*) { std::free(block); });
  blocks_taken = 0;
}

AllocationCount::~AllocationCount() { ImGui::SetAllocatorFunctions(former_alloc, former_free, former_data); }

std::size_t AllocationCount::blocks() const { return blocks_taken; }

}  // namespace marey::app
