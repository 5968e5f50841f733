#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <utility>

#include "core/base/result.h"
#include "core/motion/clip.h"

namespace marey {

/// The two axes of the ground, such that a positive turn about `up` turns the first toward the second.
[[nodiscard]] std::pair<int, int> ground_axes(Axis up);

/// A figure moved as a whole: turned about the up axis through a point, then shifted.
struct GroundTransform {
  Axis up = Axis::Y;
  double angle_deg = 0.0;
  glm::dvec3 pivot{0.0};  ///< file units; only its place on the ground counts
  glm::dvec3 shift{0.0};  ///< file units

  [[nodiscard]] glm::dvec3 apply(const glm::dvec3& position) const;
};

/// Moves the roots of a motion. Where the first rotation channel of a root turns about the up axis, the angle is added to
/// it, so turns are counted on; else its angles are found again, each frame as near to the last as the motion's own step. An
/// angle of 0 keeps the rotations to the bit, a shift of 0 without a turn the positions. Error InvalidArgument: a root
/// that is to move along an axis without a position channel, or to turn without three rotation channels.
[[nodiscard]] Status move_roots(const Skeleton& skeleton, PositionRule rule, const GroundTransform& transform, Motion& motion);

/// Where a root stands in a frame, as its channels and its OFFSET say.
[[nodiscard]] glm::dvec3 root_position(const Skeleton& skeleton, PositionRule rule, const Motion& motion, JointIndex root,
                                       FrameIndex frame);

/// By how much a rotation turns about an axis: its twist, [-180, 180] degrees.
[[nodiscard]] double twist_deg(const Skeleton& skeleton, const Motion& motion, JointIndex root, FrameIndex frame, Axis axis);

/// The turn and shift along the ground that bring points (xyz after xyz) nearest to others, least squares (Kovar, Gleicher and
/// Pighin, Motion Graphs, 2002). Points that are not finite do not count. Both spans have one length.
[[nodiscard]] GroundTransform find_alignment(Axis up, std::span<const double> points, std::span<const double> to);

}  // namespace marey
