#pragma once

#include <string>
#include <vector>

#include "core/biomechanics/body_motion.h"

namespace marey {

/// How well the frame rate of a motion carries its derivatives.
struct RateCheck {
  double velocity_error = 0.0;      ///< of central differences, as a share of the RMS of all
  double acceleration_error = 0.0;
  double coarse_share = 1.0;        ///< RMS of accelerations from every second frame, of that from all: 1/4 for noise alone
};

/// From the turning of all joints in the world, by frames one and two apart, in long clips of some frames only. The error of central differences goes with the
/// square of the distance, so a third of what both differ by is the error of the finer ones (Richardson 1911). Fewer than five
/// frames, and figures that do not turn, have no errors.
[[nodiscard]] RateCheck check_rate(const BodyMotion& body);

/// What people should be warned of: "30 frames a second do not carry the accelerations: ...". Empty where the rate is enough.
[[nodiscard]] std::string describe_rate(const RateCheck& check, double frame_time_s, bool with_accelerations);

}  // namespace marey
