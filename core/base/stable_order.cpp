#include "core/base/stable_order.h"

#include <algorithm>
#include <numeric>

namespace marey::detail {

std::vector<int> stable_order(int count, bool (*before)(const void*, int, int), const void* context) {
  std::vector<int> order(idx(count));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [=](int a, int b) { return before(context, a, b); });
  return order;
}

}  // namespace marey::detail
