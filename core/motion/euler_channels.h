#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "core/math/euler.h"
#include "core/motion/motion.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// The rotation channels of a joint whose angles can be found back from a rotation: two or three of different
/// neighbouring axes.
struct EulerChannels {
  EulerOrder order;
  int count = 0;  ///< 2 or 3; with two, the third axis of `order` has no channel
  ChannelIndex channels[3] = {};
};

/// Nothing for hinges and for unusual lists of rotations.
[[nodiscard]] std::optional<EulerChannels> find_euler_channels(const Skeleton& skeleton, JointIndex joint);

/// The angles of one frame; 0 where there is no channel.
[[nodiscard]] glm::dvec3 angles_deg_of(const Motion& motion, const EulerChannels& euler, FrameIndex frame);

}  // namespace marey
