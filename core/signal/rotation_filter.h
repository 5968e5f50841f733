#pragma once

#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <span>
#include <vector>

namespace marey {

/// A linear filter of a curve: `filter(curve, result)`, both of one length. Samples that are not finite stay.
using CurveFilter = std::function<void(std::span<const double> curve, std::span<double> result)>;

/// Filters rotations as rotations: unit quaternions, brought to one sign from frame to frame, are filtered component by
/// component and normalised again: a filtered mean of rotations near each other, which turns as they all are turned.
/// Before the first and behind the last rotation, `reach` frames continue the movement by point reflection in the group,
/// q[-k] = q[0] q[k]^-1 q[0], so that a turn at constant speed about one axis comes back. A rotation that is not finite stays.
void filter_rotations(std::span<glm::dquat> rotations, int reach, const CurveFilter& filter);

}  // namespace marey
