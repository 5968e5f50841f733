#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/biomechanics/body_model.h"
#include "core/biomechanics/body_motion.h"

namespace marey {

/// What the body as a whole does at one frame. World axes, SI.
struct BodyState {
  glm::dvec3 com{0.0};
  glm::dvec3 com_velocity{0.0};
  glm::dvec3 com_acceleration{0.0};
  glm::dvec3 momentum{0.0};
  glm::dvec3 angular_momentum{0.0};       ///< about the centre of mass
  glm::dvec3 angular_momentum_rate{0.0};  ///< its derivative: the moment of what acts from outside about the centre of mass
  double kinetic_energy = 0.0;
  double potential_energy = 0.0;  ///< 0 at the world's origin
};

/// Sums over the segments: H = sum I w + m (r - r_c) x (v - v_c). Precondition: the model fits the figure.
[[nodiscard]] BodyState find_body_state(const BodyMotion& body, const BodyModel& model, const glm::dvec3& gravity_mps2,
                                        FrameIndex frame);

/// Angular momentum about a point that stands still: H + (r_c - point) x momentum.
[[nodiscard]] glm::dvec3 angular_momentum_about(const BodyState& state, const glm::dvec3& point);

/// A force on a joint's segment from outside of the body, and a moment beside it.
struct OuterForce {
  JointIndex joint = 0;
  glm::dvec3 point{0.0};  ///< where the force acts
  glm::dvec3 force{0.0};
  glm::dvec3 moment{0.0};
};

/// What acts on the segments of a joint from its parent, at the joint's origin; on a root, from the world. World axes, SI.
struct JointLoad {
  glm::dvec3 force{0.0};
  glm::dvec3 torque{0.0};
  double power = 0.0;  ///< torque by the joint's angular velocity in its parent, W
};

/// The inward half of the recursive Newton-Euler method: the load of each joint of one frame, in the order of joints. What
/// the segments need beside gravity and `outer` comes from the parent; at a root it is what holds the body, or a residual.
void find_joint_loads(const BodyMotion& body, const Skeleton& skeleton, const BodyModel& model, const glm::dvec3& gravity_mps2,
                      FrameIndex frame, std::span<const OuterForce> outer, std::span<JointLoad> loads);

}  // namespace marey
