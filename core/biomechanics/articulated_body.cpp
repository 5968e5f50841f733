#include "core/biomechanics/articulated_body.h"

#include <utility>

namespace marey {
namespace {

constexpr double kNothing = 1e-10;

const JointState kWorld;

/// The matrix of v x.
glm::dmat3 cross_matrix(const glm::dvec3& v) { return {0.0, v.z, -v.y, -v.z, 0.0, v.x, v.y, -v.x, 0.0}; }

double trace(const glm::dmat3& m) { return m[0][0] + m[1][1] + m[2][2]; }

/// Gauss-Jordan elimination of one axis; after that of all axes -m is the inverse.
void sweep(glm::dmat3& m, int k) {
  const double pivot = m[k][k];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (i != k && j != k) m[i][j] -= m[i][k] * m[k][j] / pivot;
    }
  }
  for (int i = 0; i < 3; ++i) {
    m[i][k] /= pivot;
    m[k][i] /= pivot;
  }
  m[k][k] = -1.0 / pivot;
}

/// Of a symmetric matrix without negative directions: where some direction has nothing, the axes that are left out get 0, and
/// the others solve what can be solved.
glm::dmat3 inverse_of(glm::dmat3 m) {
  const double least = kNothing * trace(m);
  bool is_swept[3] = {};
  for (int round = 0; round < 3; ++round) {
    int k = -1;
    for (int i = 0; i < 3; ++i) {
      if (!is_swept[i] && (k < 0 || m[i][i] > m[k][k])) k = i;
    }
    if (!(m[k][k] > least)) break;
    sweep(m, k);
    is_swept[k] = true;
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m[i][j] = is_swept[i] && is_swept[j] ? -m[i][j] : 0.0;
  }
  return m;
}

}  // namespace

ArticulatedBody::ArticulatedBody(std::vector<Link> links, const glm::dvec3& gravity_mps2)
    : links_(std::move(links)), gravity_(gravity_mps2), work_(links_.size()) {}

const JointState& ArticulatedBody::parent_of(std::size_t i) const {
  return links_[i].parent == kNoParent ? kWorld : work_[idx(links_[i].parent)].world;
}

void ArticulatedBody::place(std::size_t i, const LinkState& state) {
  const Link& link = links_[i];
  const JointState& parent = parent_of(i);
  const bool slides = link.kind == LinkKind::Slide;
  Work& work = work_[i];
  JointState& world = work.world;
  world.rotation = parent.rotation * state.rotation;
  work.axes = glm::mat3_cast(world.rotation);
  work.arm = parent.rotation * link.offset + state.shift;
  const glm::dvec3 turning = slides ? glm::dvec3(0.0) : work.axes * state.speed;
  const glm::dvec3 swinging = glm::cross(parent.angular_velocity, work.arm);
  world.angular_velocity = parent.angular_velocity + turning;
  world.position = parent.position + work.arm;
  world.velocity = parent.velocity + swinging + (slides ? state.speed : glm::dvec3(0.0));
  work.turn_bias = glm::cross(parent.angular_velocity, turning);
  work.shift_bias = glm::cross(parent.angular_velocity, swinging);
}

// The inertia of the link alone, with what its turning and its weight ask for, and its energies.
void ArticulatedBody::weigh(std::size_t i) {
  const Link& link = links_[i];
  Work& work = work_[i];
  const JointState& world = work.world;
  const glm::dvec3& w = world.angular_velocity;
  const glm::dvec3 moment = work.axes * link.moment;
  Inertia& inertia = work.inertia;
  inertia.turn = work.axes * link.inertia * glm::transpose(work.axes);
  inertia.cross = cross_matrix(moment);
  inertia.shift = glm::dmat3(link.mass);
  const glm::dvec3 spin = inertia.turn * w;
  const glm::dvec3 swing = glm::cross(w, moment);
  inertia.moment = glm::cross(w, spin) - glm::cross(moment, gravity_);
  inertia.force = glm::cross(w, swing) - link.mass * gravity_;
  kinetic_energy_ += 0.5 * glm::dot(w, spin) + glm::dot(world.velocity, swing + 0.5 * link.mass * world.velocity);
  potential_energy_ -= glm::dot(gravity_, link.mass * world.position + moment);
}

void ArticulatedBody::find_gain(std::size_t i) {
  Work& work = work_[i];
  const glm::dmat3& turn = work.inertia.turn;
  work.gain = glm::dmat3(0.0);
  switch (links_[i].kind) {
    case LinkKind::Fixed: break;
    case LinkKind::Slide: work.gain = inverse_of(work.inertia.shift); break;
    case LinkKind::Ball:
      // By its own axes, in which what has no inertia stays where it is.
      work.gain = work.axes * inverse_of(glm::transpose(work.axes) * turn * work.axes) * glm::transpose(work.axes);
      break;
    case LinkKind::Hinge: {
      const glm::dvec3 axis = work.axes * links_[i].axis;
      const double moment = glm::dot(axis, turn * axis);
      if (moment > kNothing * trace(turn)) work.gain = glm::outerProduct(axis, axis) / moment;
      break;
    }
  }
}

void ArticulatedBody::hang_on_parent(std::size_t i) {
  const Work& work = work_[i];
  const auto& [turn, cross, shift, moment, force] = work.inertia;
  const glm::dmat3 back = glm::transpose(cross);
  const glm::dmat3 turn_gain = turn * work.gain;
  const glm::dmat3 back_gain = back * work.gain;
  // What is left of it once the joint gives way.
  const glm::dmat3 turn_left = turn - turn_gain * turn;
  const glm::dmat3 cross_left = cross - turn_gain * cross;
  const glm::dmat3 shift_left = shift - back_gain * cross;
  const glm::dvec3 moment_left = moment - turn_gain * moment + turn_left * work.turn_bias + cross_left * work.shift_bias;
  const glm::dvec3 force_left =
      force - back_gain * moment + glm::transpose(cross_left) * work.turn_bias + shift_left * work.shift_bias;
  // And the same about the parent's origin.
  const glm::dmat3 arm = cross_matrix(work.arm);
  Inertia& parent = work_[idx(links_[i].parent)].inertia;
  parent.turn += turn_left - cross_left * arm + arm * (glm::transpose(cross_left) - shift_left * arm);
  parent.cross += cross_left + arm * shift_left;
  parent.shift += shift_left;
  parent.moment += moment_left + glm::cross(work.arm, force_left);
  parent.force += force_left;
}

glm::dvec3 ArticulatedBody::accelerate(std::size_t i) {
  Work& work = work_[i];
  JointState& world = work.world;
  const JointState& parent = parent_of(i);
  const Inertia& inertia = work.inertia;
  const glm::dvec3 turn = parent.angular_acceleration + work.turn_bias;
  const glm::dvec3 shift = parent.acceleration + glm::cross(parent.angular_acceleration, work.arm) + work.shift_bias;
  world.angular_acceleration = turn;
  world.acceleration = shift;
  if (links_[i].kind == LinkKind::Slide) {
    const glm::dvec3 own = -(work.gain * (glm::transpose(inertia.cross) * turn + inertia.shift * shift + inertia.force));
    world.acceleration += own;
    return own;
  }
  const glm::dvec3 own = -(work.gain * (inertia.turn * turn + inertia.cross * shift + inertia.moment));
  world.angular_acceleration += own;
  return glm::transpose(work.axes) * own;
}

void ArticulatedBody::find_accelerations(std::span<const LinkState> states, std::span<glm::dvec3> accelerations) {
  kinetic_energy_ = 0.0;
  potential_energy_ = 0.0;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    place(i, states[i]);
    weigh(i);
  }
  for (std::size_t i = links_.size(); i-- > 0;) {
    find_gain(i);
    if (links_[i].parent != kNoParent) hang_on_parent(i);
  }
  for (std::size_t i = 0; i < links_.size(); ++i) accelerations[i] = accelerate(i);
}

}  // namespace marey
