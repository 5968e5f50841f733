#pragma once

#include <utility>
#include <vector>

#include "core/base/index.h"

/// std::stable_sort, compiled once for all kinds of elements: each copy of it would weigh some kilobytes in the page.
namespace marey {

namespace detail {
[[nodiscard]] std::vector<int> stable_order(int count, bool (*before)(const void*, int, int), const void* context);
}

/// The indices from 0 to count - 1, those first that `before(a, b)` puts ahead; equal ones stay in their order.
template <class Before>
[[nodiscard]] std::vector<int> stable_order(int count, const Before& before) {
  return detail::stable_order(count, [](const void* context, int a, int b) { return (*static_cast<const Before*>(context))(a, b); }, &before);
}

/// Puts the elements into that order; `before(a, b)` takes elements.
template <class Element, class Before>
void sort_stably(std::vector<Element>& list, const Before& before) {
  std::vector<Element> sorted;
  sorted.reserve(list.size());
  for (const int i : stable_order(size_of(list), [&](int a, int b) { return before(list[idx(a)], list[idx(b)]); })) {
    sorted.push_back(std::move(list[idx(i)]));
  }
  list = std::move(sorted);
}

}  // namespace marey
