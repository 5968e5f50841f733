#include "tests/core/biomechanics/chain_fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/motion/euler_channels.h"

namespace marey::test {
namespace {

glm::dvec3 unit_of(int axis) {
  glm::dvec3 unit(0.0);
  unit[axis] = 1.0;
  return unit;
}

/// In the world, as the rotation channels turn one after the other.
std::vector<glm::dvec3> free_axes_of(const Figure& figure, const BodyMotion& body, JointIndex joint) {
  std::vector<Axis> axes;
  for (const Channel& channel : figure.skeleton.channels(joint)) {
    if (is_rotation(channel.kind)) axes.push_back(axis_of(channel.kind));
  }
  const JointIndex parent = figure.skeleton.parent(joint);
  const glm::dquat base = parent == kNoParent ? glm::dquat(1.0, 0.0, 0.0, 0.0) : body.state(0, parent).rotation;
  if (axes.size() == 1) return {base * unit_of(static_cast<int>(axes[0]))};
  const auto euler = find_euler_channels(figure.skeleton, joint);
  if (!euler) return {};
  if (euler->count == 3) return {unit_of(0), unit_of(1), unit_of(2)};
  return {base * unit_of(static_cast<int>(axes[0])), body.state(0, joint).rotation * unit_of(static_cast<int>(axes[1]))};
}

}  // namespace

PassiveChain Figure::let_go() const {
  Result<PassiveChain> chain = PassiveChain::make(skeleton, model, state, settings);
  EXPECT_TRUE(chain) << (chain ? "" : chain.error().message);
  return std::move(*chain);
}

Figure make_figure(Skeleton skeleton, BodyModel model) {
  Figure figure;
  const std::size_t count = idx(skeleton.joint_count());
  figure.state.rotations.resize(count, glm::dquat(1.0, 0.0, 0.0, 0.0));
  figure.state.angular_velocities.resize(count, glm::dvec3(0.0));
  figure.state.velocities.resize(count, glm::dvec3(0.0));
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) figure.state.positions.push_back(skeleton.offset(joint));
  figure.skeleton = std::move(skeleton);
  figure.model = std::move(model);
  return figure;
}

Figure make_rods(const std::vector<double>& masses, double length, const std::string& channels) {
  std::vector<figures::JointPlan> plan;
  BodyModel model;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const glm::dvec3 offset(0.0, i == 0 ? 0.0 : -length, 0.0);
    const std::string name(1, static_cast<char>('A' + i));
    plan.push_back({name, static_cast<JointIndex>(i) - 1, offset, figures::channels(channels), {}});
    const double moment = masses[i] * length * length / 12.0;
    model.segments.push_back({static_cast<JointIndex>(i), masses[i], {0.0, -0.5 * length, 0.0}, glm::dmat3(moment)});
    model.segments.back().inertia_kgm2[1][1] = 0.0;
  }
  return make_figure(figures::make_skeleton(plan), model);
}

Figure make_top(double mass, const glm::dvec3& com, const glm::dvec3& moments) {
  BodyModel model;
  model.segments.push_back({0, mass, com, glm::dmat3(0.0)});
  for (int i = 0; i < 3; ++i) model.segments[0].inertia_kgm2[i][i] = moments[i];
  return make_figure(figures::make_skeleton({{"Top", kNoParent, glm::dvec3(0.0), figures::channels("xyzZXY"), {}}}), model);
}

Figure make_random_figure(int joint_count, unsigned seed, bool root_held) {
  Clip clip;
  clip.skeleton = figures::make_random_skeleton(joint_count, seed);
  clip.motion = figures::make_random_motion(clip.skeleton, 1, 60.0, seed);
  clip.settings.metres_per_unit = 0.05;
  for (ChannelIndex channel = 0; channel < clip.motion.channel_count(); ++channel) {
    if (is_position(clip.skeleton.channel(channel).kind)) clip.motion.channel_samples(channel)[0] *= 0.2;
  }
  Figure figure;
  figure.state = *find_chain_state(clip, 0, false);
  figure.model = make_random_model(clip.skeleton, seed);
  figure.skeleton = std::move(clip.skeleton);
  figure.settings.root_held = root_held;
  figure.settings.gravity_mps2 = {0.3, -9.81, 0.2};
  std::mt19937 random(seed);
  const auto vector = [&] {
    std::uniform_real_distribution<double> coordinate(-2.0, 2.0);
    return glm::dvec3(coordinate(random), coordinate(random), coordinate(random));
  };
  for (glm::dvec3& velocity : figure.state.angular_velocities) velocity = vector();
  for (glm::dvec3& velocity : figure.state.velocities) velocity = vector();
  return figure;
}

BodyMotion body_of(const PassiveChain& chain) {
  BodyMotion body;
  body.joint_count = chain.joint_count();
  body.frame_count = 1;
  body.frame_time_s = 0.01;
  body.metres_per_unit = 1.0;
  body.states = chain.world_states();
  return body;
}

BodyState whole_of(const Figure& figure, const PassiveChain& chain) {
  return find_body_state(body_of(chain), figure.model, figure.settings.gravity_mps2, 0);
}

double largest_torque_share(const Figure& figure, const PassiveChain& chain) {
  const BodyMotion body = body_of(chain);
  std::vector<JointLoad> loads(idx(body.joint_count));
  find_joint_loads(body, figure.skeleton, figure.model, figure.settings.gravity_mps2, 0, {}, loads);
  double largest = 0.0;
  double size = total_mass_kg(figure.model) * 9.81;
  for (JointIndex joint = 0; joint < body.joint_count; ++joint) {
    const JointLoad& load = loads[idx(joint)];
    size = std::max({size, glm::length(load.torque), glm::length(load.force)});
    for (const glm::dvec3& axis : free_axes_of(figure, body, joint)) {
      largest = std::max(largest, std::abs(glm::dot(axis, load.torque)));
    }
    const bool falls = figure.skeleton.parent(joint) == kNoParent && !figure.settings.root_held;
    if (falls) largest = std::max(largest, glm::length(load.force));
  }
  return largest / size;
}

}  // namespace marey::test
