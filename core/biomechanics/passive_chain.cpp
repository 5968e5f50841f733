#include "core/biomechanics/passive_chain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/biomechanics/chain_links.h"
#include "core/math/rotation_vector.h"

namespace marey {
namespace {

constexpr double kMostStep_s = 0.01;
constexpr double kLeastStep_s = 1e-5;
// As long as nothing moves much, of the energy of a fall through all links.
constexpr double kLeastShare = 1e-3;
constexpr double kRoundingShare = 1e-13;

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

LinkState moved(const LinkState& from, LinkKind kind, const glm::dvec3& turn, const glm::dvec3& speed) {
  LinkState to = from;
  to.speed += speed;
  if (kind == LinkKind::Slide) {
    to.shift += turn;
  } else if (kind != LinkKind::Fixed) {
    to.rotation = glm::normalize(from.rotation * rotation_by(turn));
  }
  return to;
}

/// How fast the rotation vector of a turn grows with an angular velocity in the turned axes, to the order that the method needs.
glm::dvec3 turn_rate(LinkKind kind, const glm::dvec3& turn, const glm::dvec3& speed) {
  if (kind != LinkKind::Ball) return speed;
  const glm::dvec3 across = glm::cross(turn, speed);
  return speed + 0.5 * across + glm::cross(turn, across) / 12.0;
}

Status check_state(const ChainState& state, int joint_count) {
  bool finite = true;
  for (std::size_t i = 0; i < idx(joint_count); ++i) {
    const glm::dquat& q = state.rotations[i];
    finite = finite && std::isfinite(glm::dot(q, q)) && is_finite(state.angular_velocities[i]) && is_finite(state.positions[i]) &&
             is_finite(state.velocities[i]);
  }
  if (finite) return {};
  return Error{DiagnosticCode::NotFinite, {}, "The figure cannot be let go: its pose is not made of finite numbers.", {}, {}};
}

}  // namespace

Result<PassiveChain> PassiveChain::make(const Skeleton& skeleton, const BodyModel& model, const ChainState& state,
                                        const PassiveSettings& settings) {
  if (Status status = check_body_model(model, skeleton); !status) return status.error();
  if (Status status = check_state(state, skeleton.joint_count()); !status) return status.error();
  return PassiveChain(skeleton, state, make_chain_links(skeleton, model, state, settings.root_held), settings);
}

PassiveChain::PassiveChain(const Skeleton& skeleton, const ChainState& state, ChainLinks links, const PassiveSettings& settings)
    : parents_(skeleton.parents().begin(), skeleton.parents().end()),
      rotations_(state.rotations),
      positions_(state.positions),
      first_links_(std::move(links.first_links)),
      body_(std::move(links.links), settings.gravity_mps2),
      states_(std::move(links.states)),
      saved_(states_),
      stage_(states_),
      turns_(states_.size()),
      accelerations_(states_.size()),
      rates_(states_.size()),
      sums_(states_.size()),
      change_per_second_(settings.change_per_second),
      step_s_(kMostStep_s) {
  double mass = 0.0;
  double length = 0.0;
  for (const Link& link : body_.links()) {
    mass += link.mass;
    if (link.parent != kNoParent) length += glm::length(link.offset);
    if (link.mass > 0.0) length += glm::length(link.moment) / link.mass;
  }
  reach_energy_ = mass * glm::length(settings.gravity_mps2) * length;
  evaluate(states_);
  start_energy_ = energy();
  keep_accounts();
}

void PassiveChain::evaluate(std::span<const LinkState> states) {
  body_.find_accelerations(states, accelerations_);
  ++evaluations_;
}

void PassiveChain::step(double seconds) {
  constexpr double kAt[] = {0.5, 0.5, 1.0};
  constexpr double kWeights[] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
  const std::vector<Link>& links = body_.links();
  for (std::size_t i = 0; i < links.size(); ++i) {
    rates_[i] = {states_[i].speed, accelerations_[i]};
    sums_[i] = {kWeights[0] * rates_[i].turn, kWeights[0] * rates_[i].speed};
  }
  for (std::size_t stage = 0; stage < 3; ++stage) {
    const double time = kAt[stage] * seconds;
    for (std::size_t i = 0; i < links.size(); ++i) {
      turns_[i] = time * rates_[i].turn;
      stage_[i] = moved(states_[i], links[i].kind, turns_[i], time * rates_[i].speed);
    }
    evaluate(stage_);
    for (std::size_t i = 0; i < links.size(); ++i) {
      rates_[i] = {turn_rate(links[i].kind, turns_[i], stage_[i].speed), accelerations_[i]};
      sums_[i].turn += kWeights[stage + 1] * rates_[i].turn;
      sums_[i].speed += kWeights[stage + 1] * rates_[i].speed;
    }
  }
  for (std::size_t i = 0; i < links.size(); ++i) {
    states_[i] = moved(states_[i], links[i].kind, seconds * sums_[i].turn, seconds * sums_[i].speed);
  }
  evaluate(states_);
}

// The change of energy as a share of what it may be, every step's without its sign; stops where it is more, or no number.
double PassiveChain::try_steps(double seconds, int steps) {
  double change = 0.0;
  double largest = std::max(largest_kinetic_, kLeastShare * reach_energy_);
  double share = 0.0;
  for (int i = 0; i < steps && share <= 1.0; ++i) {
    const double before = energy();
    step(seconds / steps);
    change += std::abs(energy() - before);
    largest = std::max(largest, kinetic_energy());
    if (change > 0.0) share = change / (change_per_second_ * seconds * largest + kRoundingShare * reach_energy_);
    if (!std::isfinite(change)) return std::numeric_limits<double>::infinity();
  }
  return share;
}

void PassiveChain::keep_accounts() {
  largest_kinetic_ = std::max(largest_kinetic_, kinetic_energy());
  largest_change_ = std::max(largest_change_, std::abs(energy() - start_energy_));
}

Status PassiveChain::advance(double seconds) {
  constexpr double kEasy = 1.0 / 40.0;  // twice the step makes sixteen to thirty-two times the change
  saved_ = states_;
  const double usual_step_s = step_s_;
  while (step_s_ >= std::min(kLeastStep_s, seconds)) {
    const int steps = static_cast<int>(std::max(1.0, std::ceil(seconds / step_s_ - 1e-9)));
    const double share = try_steps(seconds, steps);
    if (share <= 1.0) {
      step_s_ = seconds / steps;
      if (share < kEasy) step_s_ = std::min(2.0 * step_s_, kMostStep_s);
      keep_accounts();
      return {};
    }
    states_ = saved_;
    evaluate(states_);
    step_s_ = 0.5 * seconds / steps;
  }
  step_s_ = usual_step_s;
  return Error{DiagnosticCode::InvalidArgument, {},
               "The figure turns too fast to be followed; let it go at rest, or at another frame.", {}, {}};
}

void PassiveChain::advance(double seconds, int steps) {
  for (int i = 0; i < steps; ++i) step(seconds / steps);
  keep_accounts();
}

glm::dquat PassiveChain::rotation(JointIndex joint) const {
  if (first_links_[idx(joint)] == first_links_[idx(joint) + 1]) return rotations_[idx(joint)];
  glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
  for (int i = first_links_[idx(joint)]; i < first_links_[idx(joint) + 1]; ++i) rotation = rotation * states_[idx(i)].rotation;
  return rotation;
}

glm::dvec3 PassiveChain::position(JointIndex joint) const {
  const int first = first_links_[idx(joint)];
  const bool slides = first < first_links_[idx(joint) + 1] && body_.links()[idx(first)].kind == LinkKind::Slide;
  return slides ? body_.world(first).position : positions_[idx(joint)];
}

std::vector<JointState> PassiveChain::world_states() const {
  std::vector<JointState> states(parents_.size());
  for (std::size_t joint = 0; joint < states.size(); ++joint) {
    const int end = first_links_[joint + 1];
    if (first_links_[joint] < end) {
      states[joint] = body_.world(end - 1);
      continue;
    }
    if (parents_[joint] != kNoParent) states[joint] = state_of_point(states[idx(parents_[joint])], positions_[joint]);
    else states[joint].position = positions_[joint];
    states[joint].rotation = states[joint].rotation * rotations_[joint];
  }
  return states;
}

Status PassiveMotion::add_frame(PassiveChain& chain, double frame_time_s) {
  if (Status status = chain.advance(frame_time_s); !status) {
    Error error = status.error();
    error.message = fmt::format("After {:.3g} s: {}", frame_count() * frame_time_s, error.message);
    return error;
  }
  if (frame_count() == 0) {
    joint_count = chain.joint_count();
    for (JointIndex joint = 0; joint < joint_count; ++joint) {
      if (chain.is_root(joint)) roots.push_back(joint);
    }
  }
  for (JointIndex joint = 0; joint < joint_count; ++joint) rotations.push_back(chain.rotation(joint));
  for (const JointIndex root : roots) root_positions.push_back(chain.position(root));
  kinetic_energies.push_back(chain.kinetic_energy());
  potential_energies.push_back(chain.potential_energy());
  energy_drift = chain.energy_drift();
  return {};
}

Result<PassiveMotion> find_passive_motion(PassiveChain chain, double frame_time_s, int frame_count,
                                          const std::function<bool(double)>& carry_on) {
  PassiveMotion motion;
  for (int frame = 0; frame < frame_count; ++frame) {
    if (Status status = motion.add_frame(chain, frame_time_s); !status) return status.error();
    if (carry_on && !carry_on((frame + 1.0) / frame_count)) {
      return Error{DiagnosticCode::Cancelled, {}, "Letting the figure go was stopped.", {}, {}};
    }
  }
  return motion;
}

}  // namespace marey
