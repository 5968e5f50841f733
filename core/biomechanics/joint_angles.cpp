#include "core/biomechanics/joint_angles.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/math/angle.h"
#include "core/motion/euler_channels.h"

namespace marey {

NodeIndex find_bone_tip(const Skeleton& skeleton, JointIndex joint) {
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (skeleton.node(node).parent == skeleton.node_of(joint) && skeleton.node(node).offset != glm::dvec3(0.0)) return node;
  }
  return kNoParent;
}

glm::dvec3 angles_in_planes(const glm::dvec3& vector) {
  constexpr double kUpright = 1e-9;  // of the length
  glm::dvec3 angles(std::numeric_limits<double>::quiet_NaN());
  for (int axis = 0; axis < 3; ++axis) {
    const double first = vector[(axis + 1) % 3];
    const double second = vector[(axis + 2) % 3];
    if (std::hypot(first, second) > kUpright * glm::length(vector)) angles[axis] = std::atan2(second, first);
  }
  return angles;
}

double find_included_angle(const Skeleton& skeleton, const FilePoses& poses, JointIndex joint, FrameIndex frame) {
  const NodeIndex origin = skeleton.node_of(joint);
  const NodeIndex tip = find_bone_tip(skeleton, joint);
  const NodeIndex parent = skeleton.node(origin).parent;
  if (tip == kNoParent || parent == kNoParent) return std::numeric_limits<double>::quiet_NaN();
  const glm::dvec3 own = poses.position(frame, tip) - poses.position(frame, origin);
  const glm::dvec3 back = poses.position(frame, parent) - poses.position(frame, origin);
  // By the tangent, as the cosine has no digits left near 0 and pi.
  const double sine = glm::length(glm::cross(own, back));
  const double cosine = glm::dot(own, back);
  return sine == 0.0 && cosine == 0.0 ? std::numeric_limits<double>::quiet_NaN() : std::atan2(sine, cosine);
}

void unroll(std::span<glm::dvec3> angles_rad) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  for (int c = 0; c < 3; ++c) {
    double previous = std::numeric_limits<double>::quiet_NaN();
    for (glm::dvec3& angles : angles_rad) {
      if (std::isnan(angles[c])) continue;
      if (!std::isnan(previous)) angles[c] += kTurn * std::round((previous - angles[c]) / kTurn);
      previous = angles[c];
    }
  }
}

EulerAngles::EulerAngles(const Skeleton& skeleton, JointIndex joint) {
  if (const auto euler = find_euler_channels(skeleton, joint)) order_ = euler->order;
}

glm::dvec3 EulerAngles::angles_of(const glm::dquat& rotation, const glm::dvec3& previous_rad) const {
  const int axes[3] = {static_cast<int>(order_.first), static_cast<int>(order_.second), static_cast<int>(order_.third)};
  const glm::dvec3 previous(previous_rad[axes[0]], previous_rad[axes[1]], axes[0] == axes[2] ? 0.0 : previous_rad[axes[2]]);
  const glm::dvec3 angles = euler_near(order_, glm::mat3_cast(rotation), kDegreesPerRadian * previous);
  glm::dvec3 by_axis(0.0);
  for (int i = 0; i < 3; ++i) by_axis[axes[i]] += to_radians(angles[i]);
  return by_axis;
}

}  // namespace marey
