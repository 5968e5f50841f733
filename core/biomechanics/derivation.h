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
};

/// How velocities and accelerations come of samples.
struct Derivation {
  DerivationKind kind = DerivationKind::Central;
  double cutoff_hz = 6.0;  ///< of Butterworth, > 0
  int window = 7;          ///< of Savitzky-Golay: odd, 3 or more frames
  int degree = 3;          ///< of Savitzky-Golay: 2 ... window - 1
};

/// "central", "butterworth:6", "savgol:7,3" or "gcv". Error InvalidArgument for anything else.
[[nodiscard]] Result<Derivation> parse_derivation(std::string_view text);

/// As parse_derivation() reads it.
[[nodiscard]] std::string describe(const Derivation& derivation);

}  // namespace marey
