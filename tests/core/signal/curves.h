#pragma once

#include <vector>

namespace marey::test {

/// start, start + slope, ...
[[nodiscard]] std::vector<double> make_line(int count, double start, double slope);

/// The synthetic movement of the reference sheet, 200 samples at 100 Hz: sin 2 pi t + 0.3 sin(6 pi t + 0.5), with its exact
/// derivatives and with the noise 0.005 sqrt 3 (2 u - 1), u of the generator s = 1664525 s + 1013904223 mod 2^32 from 12345.
struct SyntheticMovement {
  static constexpr double kRateHz = 100.0;
  std::vector<double> angle;
  std::vector<double> velocity;
  std::vector<double> acceleration;
  std::vector<double> noisy;
};
[[nodiscard]] SyntheticMovement make_synthetic_movement();

/// Root mean square of the difference over the samples 10 to 189.
[[nodiscard]] double rms_error(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace marey::test
