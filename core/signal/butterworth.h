#pragma once

#include <span>

namespace marey {

/// A low-pass of second order: y[n] = a0 x[n] + a1 x[n-1] + a2 x[n-2] + b1 y[n-1] + b2 y[n-2].
struct ButterworthCoefficients {
  double a0 = 1.0;
  double a1 = 0.0;
  double a2 = 0.0;
  double b1 = 0.0;
  double b2 = 0.0;
};

/// Butterworth low-pass whose gain is 1/sqrt(2) at `cutoff_hz` after `passes` (>= 1) passes: the correction
/// (2^(1/passes) - 1)^(1/4) is applied to the tangent (Winter, Biomechanics and Motor Control of Human Movement, 4th ed.
/// 2009, p. 69; Robertson et al., Research Methods in Biomechanics, p. 288). 0 < cutoff_hz < rate_hz / 2.
[[nodiscard]] ButterworthCoefficients make_butterworth(double cutoff_hz, double rate_hz, int passes);

/// Gain of one pass at a frequency, >= 0.
[[nodiscard]] double butterworth_gain(const ButterworthCoefficients& filter, double frequency_hz, double rate_hz);

/// The curve filtered forwards and backwards, so without lag, with gain 1/sqrt(2) at `cutoff_hz`; `filtered` has the
/// curve's length. 0 < cutoff_hz < rate_hz / 2. The curve is continued by point reflection about its first and last
/// finite sample, far enough that the start of the filter leaves no trace; constants and straight lines stay exact.
/// Samples that are not finite stay; the others are filtered as if a straight line bridged them. Linear in the frames,
/// but for cut-offs whose period is longer than the curve: up to 20 times as much.
void compute_butterworth(std::span<const double> curve, double cutoff_hz, double rate_hz, std::span<double> filtered);

}  // namespace marey
