#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/biomechanics/file_poses.h"
#include "core/math/euler.h"

namespace marey {

/// The first child of a joint, or end site, that is not in the same place in the rest pose: where its bone ends; kNoParent for
/// none.
[[nodiscard]] NodeIndex find_bone_tip(const Skeleton& skeleton, JointIndex joint);

/// The directions of a vector in the three planes, in radians: .z in the plane of x and y, from x to y; .x from y to z; .y from z
/// to x (Winter 2009, section 3.4.1: anticlockwise from the first axis). Not a number where it stands upright on the plane.
[[nodiscard]] glm::dvec3 angles_in_planes(const glm::dvec3& vector);

/// The angle at a joint between the bone to its parent and its own, in radians: pi where they are in line, 0 folded. Not a number
/// at a root and at a joint without a bone.
[[nodiscard]] double find_included_angle(const Skeleton& skeleton, const FilePoses& poses, JointIndex joint, FrameIndex frame);

/// Takes jumps of whole turns out of curves in radians, component by component, beginning with the first value that is a number.
void unroll(std::span<glm::dvec3> angles_rad);

/// Tait-Bryan or Euler angles in the order of a joint's rotation channels; with fewer than two of them, as ZXY.
class EulerAngles {
 public:
  EulerAngles(const Skeleton& skeleton, JointIndex joint);

  /// By axis of the channels: .x is the angle about X. In radians, the nearest to `previous_rad` of all that are the same
  /// rotation. Where an order has one axis twice, the sum of both angles.
  [[nodiscard]] glm::dvec3 angles_of(const glm::dquat& rotation, const glm::dvec3& previous_rad) const;

 private:
  EulerOrder order_;
};

}  // namespace marey
