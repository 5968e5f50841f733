#pragma once

#include <cstring>
#include <type_traits>

namespace marey {

/// Whether two values are the same to the bit: 0.0 and -0.0 differ, a NaN is the same as itself.
template <class T>
[[nodiscard]] bool same_bits(const T& a, const T& b) {
  static_assert(std::is_trivially_copyable_v<T>);
  return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace marey
