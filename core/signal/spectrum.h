#pragma once

#include <span>
#include <vector>

namespace marey {

/// Amplitudes of a curve's oscillations by frequency.
struct Spectrum {
  double step_hz = 0.0;            ///< amplitudes[k] is that of k * step_hz
  std::vector<double> amplitudes;  ///< in the curve's unit, from 0 Hz to half the rate; empty for fewer than 4 samples
};

/// Single-sided amplitude spectrum: a long sine of amplitude 1 has a peak of 1. The straight line of least squares is
/// taken out first and the rest faded out at both ends (Hann). Samples that are not finite are bridged by straight lines.
/// Costs n log n.
[[nodiscard]] Spectrum compute_spectrum(std::span<const double> curve, double rate_hz);

}  // namespace marey
