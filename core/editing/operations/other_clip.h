#pragma once

#include <string>
#include <vector>

#include "core/editing/operation.h"

namespace marey {

/// The movement of another clip on the figure of this one.
struct OtherMotion {
  Motion motion;                          ///< has this clip's channels and frame time
  std::vector<JointIndex> missing;        ///< joints of this figure that the other one does not have
  std::vector<std::string> notes;         ///< sentences about what people should know of it
};

/// Joints are found by their names, channels by their kind; rotations of another order are described in this figure's. A
/// channel that the other clip does not have keeps the value of `held_frame`. A clip of another frame rate is resampled.
/// Errors: InvalidArgument where no joint has the same name, and those of resampled().
[[nodiscard]] Result<OtherMotion> adopt_motion(const Clip& clip, const Clip& other, FrameIndex held_frame);

/// From one movement into another of the same figure and length: frame i is weights[i] of the way. Joints of two or three
/// rotations go by slerp.
[[nodiscard]] Motion mixed_motion(const Skeleton& skeleton, const Motion& from, const Motion& to, const std::vector<double>& weights);

}  // namespace marey
