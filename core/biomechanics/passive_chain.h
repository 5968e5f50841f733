#pragma once

#include <cstdint>
#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/biomechanics/articulated_body.h"
#include "core/biomechanics/chain_links.h"
#include "core/biomechanics/body_model.h"
#include "core/motion/clip.h"

namespace marey {

/// What lets a figure be.
struct PassiveSettings {
  bool root_held = true;  ///< the origins of roots stay, else they fall freely
  glm::dvec3 gravity_mps2{0.0, -9.81, 0.0};
  double change_per_second = 1e-6;  ///< how far energy may change, step by step, as a share of the largest kinetic energy
};

/// A figure that moves by gravity alone. A joint turns as its channels allow: about one axis, two, or, with three, any; so does a
/// root. Rigid are joints without rotation channels, those with lists of rotations that are no Euler angles, and those that
/// nothing with mass hangs on. Positions but those of free roots stay.
/// The accelerations are those of ArticulatedBody, so that find_joint_loads() finds no torque about a free axis. They are
/// integrated by the Runge-Kutta method of fourth order, turns by their rotation vector in each step (H. Munthe-Kaas, BIT 38,
/// 1998). A step is at most 10 ms, and shorter where energy changes by more than it may. A free root that cannot turn all ways
/// is held from it by a torque.
class PassiveChain {
 public:
  /// Errors: those of check_body_model(), NotFinite for a state that is not. `state` has all joints of the figure.
  [[nodiscard]] static Result<PassiveChain> make(const Skeleton& skeleton, const BodyModel& model, const ChainState& state,
                                                 const PassiveSettings& settings);

  /// Error InvalidArgument, and nothing is moved, where steps of 10 us are too long.
  [[nodiscard]] Status advance(double seconds);
  /// The same in so many equal steps, whatever comes of it.
  void advance(double seconds, int steps);

  [[nodiscard]] int joint_count() const { return size_of(parents_); }
  [[nodiscard]] bool is_root(JointIndex joint) const { return parents_[idx(joint)] == kNoParent; }
  /// Of a joint in its parent.
  [[nodiscard]] glm::dquat rotation(JointIndex joint) const;
  /// Of a joint's origin in its parent, m.
  [[nodiscard]] glm::dvec3 position(JointIndex joint) const;
  /// By joint, in the world, as find_joint_loads() takes them.
  [[nodiscard]] std::vector<JointState> world_states() const;

  [[nodiscard]] double kinetic_energy() const { return body_.kinetic_energy(); }
  [[nodiscard]] double potential_energy() const { return body_.potential_energy(); }
  /// How far the energy has been from that of the start, as a share of the largest kinetic energy; 0 if nothing moved.
  [[nodiscard]] double energy_drift() const { return largest_kinetic_ > 0.0 ? largest_change_ / largest_kinetic_ : 0.0; }
  /// How often all accelerations were found.
  [[nodiscard]] std::int64_t evaluation_count() const { return evaluations_; }

 private:
  PassiveChain(const Skeleton& skeleton, const ChainState& state, ChainLinks links, const PassiveSettings& settings);

  struct Rates {
    glm::dvec3 turn{0.0};
    glm::dvec3 speed{0.0};
  };

  [[nodiscard]] double energy() const { return kinetic_energy() + potential_energy(); }
  void set_speeds(const ChainState& state);
  void evaluate(std::span<const LinkState> states);
  void step(double seconds);
  [[nodiscard]] double try_steps(double seconds, int steps);
  void keep_accounts();

  std::vector<JointIndex> parents_;
  std::vector<glm::dquat> rotations_;  // by joint, at the start
  std::vector<glm::dvec3> positions_;
  std::vector<int> first_links_;  // by joint, and one behind: its links
  ArticulatedBody body_;
  std::vector<LinkState> states_;
  std::vector<LinkState> saved_;
  std::vector<LinkState> stage_;
  std::vector<glm::dvec3> turns_;  // from states_ to stage_
  std::vector<glm::dvec3> accelerations_;  // of what was evaluated last
  std::vector<Rates> rates_;               // at a stage
  std::vector<Rates> sums_;
  double change_per_second_;
  double reach_energy_ = 0.0;  // the weight by the length of all links
  double start_energy_ = 0.0;
  double largest_kinetic_ = 0.0;
  double largest_change_ = 0.0;
  double step_s_ = 0.0;
  std::int64_t evaluations_ = 0;
};

/// A passive motion by frames.
struct PassiveMotion {
  int joint_count = 0;
  std::vector<glm::dquat> rotations;  ///< [frame][joint], in the parent
  std::vector<JointIndex> roots;
  std::vector<glm::dvec3> root_positions;  ///< [frame][root], m
  std::vector<double> kinetic_energies;    ///< by frame, J
  std::vector<double> potential_energies;
  double energy_drift = 0.0;  ///< see PassiveChain

  [[nodiscard]] int frame_count() const { return size_of(kinetic_energies); }
  /// Moves a chain on by the time of a frame and adds that; always of the same chain. Errors: those of PassiveChain::advance(),
  /// with the time behind the start; no frame is added then.
  [[nodiscard]] Status add_frame(PassiveChain& chain, double frame_time_s);
};

/// The frames that follow the chain's state, which is not among them. `carry_on(share)` is called after each with how much is
/// done, 0 to 1; false stops with Cancelled. Other errors: InvalidArgument where the figure runs away.
[[nodiscard]] Result<PassiveMotion> find_passive_motion(PassiveChain chain, double frame_time_s, int frame_count,
                                                        const std::function<bool(double)>& carry_on = {});

}  // namespace marey
