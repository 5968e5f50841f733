#include "core/biomechanics/mechanics.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>

namespace marey {
namespace {

/// A segment at one frame.
struct SegmentState {
  JointState com;
  glm::dvec3 spin{0.0};       ///< I w
  glm::dvec3 spin_rate{0.0};  ///< I a + w x I w
};

SegmentState find_segment_state(const BodyMotion& body, const Segment& segment, FrameIndex frame) {
  SegmentState state;
  state.com = state_of_point(body.state(frame, segment.joint), segment.com_m);
  const glm::dmat3 turn = glm::mat3_cast(state.com.rotation);
  const glm::dmat3 inertia = turn * segment.inertia_kgm2 * glm::transpose(turn);
  const glm::dvec3& w = state.com.angular_velocity;
  state.spin = inertia * w;
  state.spin_rate = inertia * state.com.angular_acceleration + glm::cross(w, state.spin);
  return state;
}

}  // namespace

BodyState find_body_state(const BodyMotion& body, const BodyModel& model, const glm::dvec3& gravity_mps2, FrameIndex frame) {
  BodyState sum;
  const double mass = total_mass_kg(model);
  for (const Segment& segment : model.segments) {
    const SegmentState state = find_segment_state(body, segment, frame);
    sum.com += segment.mass_kg * state.com.position;
    sum.com_velocity += segment.mass_kg * state.com.velocity;
    sum.com_acceleration += segment.mass_kg * state.com.acceleration;
    sum.kinetic_energy += 0.5 * (segment.mass_kg * glm::dot(state.com.velocity, state.com.velocity) +
                                 glm::dot(state.com.angular_velocity, state.spin));
  }
  sum.momentum = sum.com_velocity;
  sum.com /= mass;
  sum.com_velocity /= mass;
  sum.com_acceleration /= mass;
  sum.potential_energy = -mass * glm::dot(gravity_mps2, sum.com);
  for (const Segment& segment : model.segments) {
    const SegmentState state = find_segment_state(body, segment, frame);
    const glm::dvec3 arm = state.com.position - sum.com;
    sum.angular_momentum += state.spin + segment.mass_kg * glm::cross(arm, state.com.velocity - sum.com_velocity);
    sum.angular_momentum_rate += state.spin_rate + segment.mass_kg * glm::cross(arm, state.com.acceleration - sum.com_acceleration);
  }
  return sum;
}

glm::dvec3 angular_momentum_about(const BodyState& state, const glm::dvec3& point) {
  return state.angular_momentum + glm::cross(state.com - point, state.momentum);
}

void find_joint_loads(const BodyMotion& body, const Skeleton& skeleton, const BodyModel& model, const glm::dvec3& gravity_mps2,
                      FrameIndex frame, std::span<const OuterForce> outer, std::span<JointLoad> loads) {
  std::fill(loads.begin(), loads.end(), JointLoad{});
  const auto add_at = [&](JointIndex joint, const glm::dvec3& point, const glm::dvec3& force, const glm::dvec3& moment) {
    JointLoad& load = loads[idx(joint)];
    load.force += force;
    load.torque += moment + glm::cross(point - body.state(frame, joint).position, force);
  };
  for (const Segment& segment : model.segments) {
    const SegmentState state = find_segment_state(body, segment, frame);
    add_at(segment.joint, state.com.position, segment.mass_kg * (state.com.acceleration - gravity_mps2), state.spin_rate);
  }
  for (const OuterForce& force : outer) add_at(force.joint, force.point, -force.force, -force.moment);
  for (JointIndex joint = skeleton.joint_count() - 1; joint >= 0; --joint) {
    const JointIndex parent = skeleton.parent(joint);
    JointLoad& load = loads[idx(joint)];
    const JointState& state = body.state(frame, joint);
    if (parent != kNoParent) add_at(parent, state.position, load.force, load.torque);
    const glm::dvec3 parent_velocity = parent == kNoParent ? glm::dvec3(0.0) : body.state(frame, parent).angular_velocity;
    load.power = glm::dot(load.torque, state.angular_velocity - parent_velocity);
  }
}

}  // namespace marey
