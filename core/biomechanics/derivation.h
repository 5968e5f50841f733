#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace marey {

enum class DerivationKind {
  Central,        ///< differences of the samples as they are
  Butterworth,    ///< zero-lag low-pass of second order, then differences
  SavitzkyGolay,  ///< derivatives of a polynomial over a window of frames
  Gcv,            ///< natural quintic spline, smoothed by generalised cross-validation
  Spline,         ///< the same spline, as smooth as a known noise allows
};

/// How velocities and accelerations come of samples.
struct Derivation {
  DerivationKind kind = DerivationKind::Central;
  double cutoff_hz = 6.0;  ///< of Butterworth, > 0
  int window = 7;          ///< of Savitzky-Golay: odd, 3 or more frames
  int degree = 3;          ///< of Savitzky-Golay: 2 ... window - 1
  double noise_deg = 0.5;  ///< of Spline: RMS of what is noise in angles, > 0
  double noise_mm = 1.0;   ///< of Spline: and in places, > 0
  friend bool operator==(const Derivation&, const Derivation&) = default;
};

/// Frames at either end of a clip whose velocities and accelerations lean on samples that are not there: one for central
/// differences, half the window for Savitzky-Golay, a period of the cut-off for Butterworth, and for splines, which end
/// without third derivative, as many as its polynomials have coefficients. At least one.
[[nodiscard]] int uncertain_end_frames(const Derivation& derivation, double rate_hz);

/// "central", "butterworth:6", "savgol:7,3", "gcv" or "spline:0.5,1". Error InvalidArgument for anything else.
[[nodiscard]] Result<Derivation> parse_derivation(std::string_view text);

/// As parse_derivation() reads it.
[[nodiscard]] std::string describe(const Derivation& derivation);

}  // namespace marey
