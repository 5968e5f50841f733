#pragma once

#include <span>
#include <vector>

namespace marey {

/// How far a curve is from itself filtered, root mean square, for one cut-off.
struct Residual {
  double cutoff_hz = 0.0;
  double rms = 0.0;
};

/// Winter's residual analysis (Biomechanics and Motor Control of Human Movement, 4th ed. 2009, p. 70).
struct ResidualAnalysis {
  std::vector<Residual> residuals;  ///< by rising cut-off; empty for a curve that is too short or has no rate
  double noise_rms = 0.0;           ///< where the line through the noisy part meets 0 Hz
  double slope_per_hz = 0.0;        ///< of that line, <= 0 where there is noise
  double r_squared = 0.0;           ///< how well the residuals keep to the line, 0 to 1
  double cutoff_hz = 0.0;           ///< where the residual is the noise; 0 if nothing can be suggested
};

/// Part of the frequencies up to half the rate over which the line of the noise is fitted.
struct NoiseBand {
  double from = 0.3;
  double to = 0.8;
};

/// Residuals of the zero-lag Butterworth for cut-offs from 1/100 to 90/100 of half the rate, and the cut-off that they
/// suggest. Known to smooth accelerations rather too much; clips below 50 frames a second leave little noise to measure.
/// Costs 90 filterings.
[[nodiscard]] ResidualAnalysis analyse_residuals(std::span<const double> curve, double rate_hz, NoiseBand band = {});

}  // namespace marey
