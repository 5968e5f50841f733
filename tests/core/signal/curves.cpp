#include "tests/core/signal/curves.h"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace marey::test {

std::vector<double> make_line(int count, double start, double slope) {
  std::vector<double> line;
  for (int i = 0; i < count; ++i) line.push_back(start + slope * i);
  return line;
}

SyntheticMovement make_synthetic_movement() {
  constexpr double kPi = std::numbers::pi;
  SyntheticMovement movement;
  std::uint32_t state = 12345;
  for (int i = 0; i < 200; ++i) {
    const double t = i / SyntheticMovement::kRateHz;
    const double slow = 2.0 * kPi * t;
    const double fast = 6.0 * kPi * t + 0.5;
    movement.angle.push_back(std::sin(slow) + 0.3 * std::sin(fast));
    movement.velocity.push_back(2.0 * kPi * std::cos(slow) + 0.3 * 6.0 * kPi * std::cos(fast));
    movement.acceleration.push_back(-4.0 * kPi * kPi * std::sin(slow) - 0.3 * 36.0 * kPi * kPi * std::sin(fast));
    state = 1664525u * state + 1013904223u;
    const double u = state / 4294967296.0;
    movement.noisy.push_back(movement.angle.back() + 0.005 * std::sqrt(3.0) * (2.0 * u - 1.0));
  }
  return movement;
}

double rms_error(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 10; i < 190; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / 180.0);
}

}  // namespace marey::test
