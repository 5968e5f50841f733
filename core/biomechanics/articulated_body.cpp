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

/// The inverse of a symmetric matrix without negative directions, and how many axes it has: where some direction has nothing,
/// axes are left out and get 0, and the others solve what can be solved.
struct Inverse {
  glm::dmat3 matrix{0.0};
  int axes = 0;
};

Inverse inverse_of(glm::dmat3 m) {
  const double least = kNothing * trace(m);
  Inverse inverse;
  bool is_swept[3] = {};
  while (inverse.axes < 3) {
    int k = -1;
    for (int i = 0; i < 3; ++i) {
      if (!is_swept[i] && (k < 0 || m[i][i] > m[k][k])) k = i;
    }
    if (!(m[k][k] > least)) break;
    sweep(m, k);
    is_swept[k] = true;
    ++inverse.axes;
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (is_swept[i] && is_swept[j]) inverse.matrix[i][j] = -m[i][j];
    }
  }
  return inverse;
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
  work.gives_way = false;
  switch (links_[i].kind) {
    case LinkKind::Fixed: break;
    case LinkKind::Slide: work.gain = inverse_of(work.inertia.shift).matrix; break;
    case LinkKind::Ball: {
      const Inverse inverse = inverse_of(turn);
      work.gives_way = inverse.axes == 3;
      work.gain = inverse.matrix;
      if (work.gives_way) break;
      // By its own axes what has no inertia stays where it is.
      const glm::dmat3 back = glm::transpose(work.axes);
      work.gain = work.axes * inverse_of(back * turn * work.axes).matrix * back;
      break;
    }
    case LinkKind::Hinge: {
      const glm::dvec3 axis = work.axes * links_[i].axis;
      const double moment = glm::dot(axis, turn * axis);
      if (moment > kNothing * trace(turn)) work.gain = glm::outerProduct(axis, axis) / moment;
      break;
    }
  }
}

// What is left of it once the joint gives way.
ArticulatedBody::Inertia ArticulatedBody::left_of(const Work& work) const {
  const auto& [turn, cross, shift, moment, force] = work.inertia;
  const glm::dmat3 back_gain = glm::transpose(cross) * work.gain;
  Inertia left;
  left.shift = shift - back_gain * cross;
  left.force = force - back_gain * moment + left.shift * work.shift_bias;
  if (work.gives_way) return left;  // turning takes nothing
  const glm::dmat3 turn_gain = turn * work.gain;
  left.turn = turn - turn_gain * turn;
  left.cross = cross - turn_gain * cross;
  left.moment = moment - turn_gain * moment + left.turn * work.turn_bias + left.cross * work.shift_bias;
  left.force += glm::transpose(left.cross) * work.turn_bias;
  return left;
}

void ArticulatedBody::hang_on_parent(std::size_t i) {
  const Work& work = work_[i];
  const Inertia left = left_of(work);
  const glm::dmat3 arm = cross_matrix(work.arm);
  const glm::dmat3 swing = arm * left.shift;
  Inertia& parent = work_[idx(links_[i].parent)].inertia;
  parent.turn -= swing * arm;
  parent.cross += swing;
  parent.shift += left.shift;
  parent.moment += glm::cross(work.arm, left.force);
  parent.force += left.force;
  if (work.gives_way) return;
  parent.turn += left.turn - left.cross * arm + arm * glm::transpose(left.cross);
  parent.cross += left.cross;
  parent.moment += left.moment;
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
