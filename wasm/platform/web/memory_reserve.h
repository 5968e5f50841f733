#pragma once

namespace marey::app {

/// Memory that is kept free for saying that there is no more: the first allocation that fails gives it back and is tried
/// again, so that what is small succeeds and what is large throws std::bad_alloc. One in a program.
class MemoryReserve {
 public:
  MemoryReserve();
  ~MemoryReserve();
  MemoryReserve(const MemoryReserve&) = delete;
  MemoryReserve& operator=(const MemoryReserve&) = delete;

  /// Takes the memory again where it was given back, as far as it is there.
  void refill();
};

}  // namespace marey::app
