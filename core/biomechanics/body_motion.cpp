#include "core/biomechanics/body_motion.h"

#include <utility>

namespace marey {
namespace {

JointState added(const JointState& parent, const JointTrack& track, std::size_t frame) {
  const glm::dquat& turn = parent.rotation;
  const glm::dvec3& w = parent.angular_velocity;
  const glm::dvec3 relative = turn * track.angular_velocities[frame];
  const glm::dvec3 arm = turn * track.origin.positions[frame];
  const glm::dvec3 sliding = turn * track.origin.velocities[frame];
  JointState state;
  state.rotation = turn * track.rotations[frame];
  state.angular_velocity = w + relative;
  state.angular_acceleration = parent.angular_acceleration + turn * track.angular_accelerations[frame] + glm::cross(w, relative);
  state.position = parent.position + arm;
  state.velocity = parent.velocity + glm::cross(w, arm) + sliding;
  state.acceleration = parent.acceleration + glm::cross(parent.angular_acceleration, arm) + glm::cross(w, glm::cross(w, arm)) +
                       2.0 * glm::cross(w, sliding) + turn * track.origin.accelerations[frame];
  return state;
}

}  // namespace

JointState state_of_point(const JointState& joint, const glm::dvec3& local_m) {
  JointState point = joint;
  const glm::dvec3 arm = joint.rotation * local_m;
  const glm::dvec3& w = joint.angular_velocity;
  point.position += arm;
  point.velocity += glm::cross(w, arm);
  point.acceleration += glm::cross(joint.angular_acceleration, arm) + glm::cross(w, glm::cross(w, arm));
  return point;
}

JointState seen_from(const JointState& frame, const JointState& what) {
  const glm::dquat turn = glm::conjugate(frame.rotation);
  const glm::dvec3& w = frame.angular_velocity;
  const glm::dvec3 place = what.position - frame.position;
  const glm::dvec3 velocity = what.velocity - frame.velocity - glm::cross(w, place);
  const glm::dvec3 spin = what.angular_velocity - w;
  JointState seen;
  seen.rotation = turn * what.rotation;
  seen.angular_velocity = turn * spin;
  seen.angular_acceleration = turn * (what.angular_acceleration - frame.angular_acceleration - glm::cross(w, spin));
  seen.position = turn * place;
  seen.velocity = turn * velocity;
  seen.acceleration = turn * (what.acceleration - frame.acceleration - glm::cross(frame.angular_acceleration, place) -
                              2.0 * glm::cross(w, velocity) - glm::cross(w, glm::cross(w, place)));
  return seen;
}

Result<BodyMotion> find_body_motion(const Clip& clip, const Derivation& derivation, double frame_time_s, double metres_per_unit) {
  const Result<std::vector<JointTrack>> tracks = find_joint_tracks(clip, derivation, frame_time_s, metres_per_unit);
  if (!tracks) return tracks.error();
  BodyMotion body;
  body.joint_count = clip.skeleton.joint_count();
  body.frame_count = clip.motion.frame_count();
  body.frame_time_s = frame_time_s;
  body.metres_per_unit = metres_per_unit;
  body.states.resize(idx(body.frame_count) * idx(body.joint_count));
  const JointState world;
  for (FrameIndex frame = 0; frame < body.frame_count; ++frame) {
    JointState* states = body.states.data() + idx(frame) * idx(body.joint_count);
    for (JointIndex joint = 0; joint < body.joint_count; ++joint) {
      const JointIndex parent = clip.skeleton.parent(joint);
      states[joint] = added(parent == kNoParent ? world : states[parent], (*tracks)[idx(joint)], idx(frame));
    }
  }
  return body;
}

}  // namespace marey
