#pragma once

#include <span>
#include <vector>

namespace marey {

/// What a Savitzky-Golay filter fits: a polynomial of `degree` to each `window` neighbouring samples.
struct SavitzkyGolay {
  int window = 7;      ///< odd, >= 1; cut to the length of the curve
  int degree = 3;      ///< >= 0; below the window
  int derivative = 0;  ///< 0, 1 or 2: which derivative of the polynomial is taken, per frame
};

/// Weights of the samples of one window for the value of the polynomial at `at` frames from the middle,
/// |at| <= (window - 1) / 2 (Savitzky and Golay 1964; by orthogonal polynomials, as in Gorry 1990).
[[nodiscard]] std::vector<double> make_savitzky_golay_weights(const SavitzkyGolay& filter, int at);

/// The curve smoothed, or its derivative per frame (per frame squared); `result` has the curve's length. Near the ends the
/// polynomials of the first and the last window are evaluated, so polynomials up to `degree` come back exactly. Samples that
/// are not finite stay; the others are fitted as if a straight line bridged them. Costs frames times window.
void compute_savitzky_golay(std::span<const double> curve, const SavitzkyGolay& filter, std::span<double> result);

}  // namespace marey
