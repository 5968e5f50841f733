#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/biomechanics/joint_tracks.h"

namespace marey {

/// How one joint moves in the world at one frame: the frame that its children hang on, and its origin. World axes, SI.
struct JointState {
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 angular_velocity{0.0};
  glm::dvec3 angular_acceleration{0.0};
  glm::dvec3 position{0.0};
  glm::dvec3 velocity{0.0};
  glm::dvec3 acceleration{0.0};
};

/// A point fixed to a joint, `local` metres from its origin in its axes: only position, velocity and acceleration are new.
[[nodiscard]] JointState state_of_point(const JointState& joint, const glm::dvec3& local_m);

/// A movement as it is seen from a moving frame, in its axes: also what the frame's own movement takes away or adds, such as
/// centripetal and Coriolis terms. A default state as the frame is the world.
[[nodiscard]] JointState seen_from(const JointState& frame, const JointState& what);

/// The movement of a whole figure.
struct BodyMotion {
  int joint_count = 0;
  int frame_count = 0;
  double frame_time_s = 0.0;
  double metres_per_unit = 0.01;
  std::vector<JointState> states;  ///< [frame][joint]

  [[nodiscard]] const JointState& state(FrameIndex frame, JointIndex joint) const {
    return states[idx(frame) * idx(joint_count) + idx(joint)];
  }
};

/// The outward half of the recursive Newton-Euler method (Luh, Walker and Paul 1980): from the root on, each joint's movement
/// in its parent is added to that of the parent, with the centripetal and Coriolis terms. Errors: those of
/// find_joint_tracks().
[[nodiscard]] Result<BodyMotion> find_body_motion(const Clip& clip, const Derivation& derivation, double frame_time_s,
                                                  double metres_per_unit);

}  // namespace marey
