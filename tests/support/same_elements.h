#pragma once

#include <algorithm>

namespace marey::test {

/// std::ranges::equal(), which older C++ libraries do not have.
template <class A, class B>
[[nodiscard]] bool same_elements(const A& a, const B& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

}  // namespace marey::test
