#include "core/signal/derivative.h"

#include <algorithm>
#include <cstddef>

namespace marey {

void compute_first_derivative(std::span<const double> curve, double rate_hz, std::span<double> result) {
  const std::size_t n = curve.size();
  std::fill(result.begin(), result.end(), 0.0);
  if (n < 2) return;
  for (std::size_t i = 1; i + 1 < n; ++i) result[i] = 0.5 * (curve[i + 1] - curve[i - 1]) * rate_hz;
  if (n == 2) {
    result[0] = result[1] = (curve[1] - curve[0]) * rate_hz;
    return;
  }
  result[0] = 0.5 * (-3.0 * curve[0] + 4.0 * curve[1] - curve[2]) * rate_hz;
  result[n - 1] = 0.5 * (3.0 * curve[n - 1] - 4.0 * curve[n - 2] + curve[n - 3]) * rate_hz;
}

void compute_second_derivative(std::span<const double> curve, double rate_hz, std::span<double> result) {
  const std::size_t n = curve.size();
  const double squared = rate_hz * rate_hz;
  std::fill(result.begin(), result.end(), 0.0);
  if (n < 3) return;
  for (std::size_t i = 1; i + 1 < n; ++i) result[i] = (curve[i + 1] - 2.0 * curve[i] + curve[i - 1]) * squared;
  if (n == 3) {
    result[0] = result[2] = result[1];
    return;
  }
  result[0] = (2.0 * curve[0] - 5.0 * curve[1] + 4.0 * curve[2] - curve[3]) * squared;
  result[n - 1] = (2.0 * curve[n - 1] - 5.0 * curve[n - 2] + 4.0 * curve[n - 3] - curve[n - 4]) * squared;
}

}  // namespace marey
