#pragma once

#include <optional>
#include <span>
#include <vector>

namespace marey {

/// A natural quintic spline through, or near, samples at equal distances: its values and derivatives at the samples.
struct SplineFit {
  std::vector<double> values;
  std::vector<double> first;   ///< per second
  std::vector<double> second;  ///< per second squared
  double smoothing = 0.0;      ///< lambda, in seconds to the fifth
  double freedom = 0.0;        ///< trace of the matrix from samples to values: as many independent numbers remain
  double gcv = 0.0;            ///< generalised cross-validation, N RSS / (N - freedom)^2
};

/// The spline s that minimises sum (y - s)^2 + lambda integral (s''')^2, with s''' = 0 beyond the ends (Woltring 1986, A
/// Fortran package for generalized, cross-validatory spline smoothing and differentiation; order m = 3). 0 interpolates.
/// Time and memory linear in the samples. Precondition: all samples finite, at least 6 of them, lambda >= 0.
[[nodiscard]] SplineFit fit_smoothing_spline(std::span<const double> curve, double rate_hz, double lambda);

/// The same with the lambda of the least generalised cross-validation (Craven and Wahba 1979); or, where the noise is known,
/// with the one that leaves a residual of `noise_rms`.
[[nodiscard]] SplineFit fit_smoothing_spline(std::span<const double> curve, double rate_hz,
                                             std::optional<double> noise_rms = std::nullopt);

/// The lambda with which the residuals of all curves together, squared and summed, come to `residual`: for noise that is the
/// same in each. The nearest that there is where no lambda leaves so much, or so little. Preconditions as above, for each curve.
[[nodiscard]] double find_smoothing_for_residual(std::span<const std::vector<double>> curves, double rate_hz, double residual);

}  // namespace marey
