#pragma once

#include <glm/gtc/quaternion.hpp>

#include "core/motion/motion.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// A point in time between two frames of a motion: `weight` of the way from `frame` to `next`, 0 <= weight < 1.
/// On a whole frame both are the same and weight is 0.
struct FrameBlend {
  FrameIndex frame = 0;
  FrameIndex next = 0;
  double weight = 0.0;
};

/// `frame` (0-based, with fraction) clamped to [0, frame_count - 1]; frame_count >= 1.
[[nodiscard]] FrameBlend find_frame_blend(int frame_count, double frame);

/// Linear between the two frames; exactly the sample on a whole frame.
[[nodiscard]] double sample_at(const Motion& motion, ChannelIndex channel, const FrameBlend& at);

/// Rotation of a joint relative to its parent: the product of its rotation channels in file order, whatever other
/// channels stand between them. Unit length; NaN when one of its angles is not finite.
[[nodiscard]] glm::dquat joint_rotation(const Skeleton& skeleton, const Motion& motion, JointIndex joint,
                                        FrameIndex frame);

/// The same between frames: linear in the angle for joints with at most one rotation channel (they may turn by more
/// than 180 degrees per frame), else slerp along the short way.
[[nodiscard]] glm::dquat joint_rotation(const Skeleton& skeleton, const Motion& motion, JointIndex joint,
                                        const FrameBlend& at);

}  // namespace marey
