// What holds for every passive motion, whatever the figure.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/math/angle.h"
#include "core/math/euler.h"
#include "core/motion/euler_channels.h"
#include "tests/core/biomechanics/chain_fixtures.h"

namespace marey::test {
namespace {

void expect_near(const glm::dvec3& found, const glm::dvec3& expected, double within, const char* what) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], within) << what << "." << "xyz"[i];
}

void advance(PassiveChain& chain, double seconds) {
  const Status status = chain.advance(seconds);
  ASSERT_TRUE(status.ok()) << status.error().message;
}

void advance_by_frames(PassiveChain& chain, double seconds) {
  for (int frame = 0; frame < 60.0 * seconds; ++frame) advance(chain, 1.0 / 60.0);
}

/// The gymnast of the founding paper as in its first frame.
Figure make_swinging_gymnast() {
  const Clip clip = make_gymnast();
  Figure figure;
  figure.state = *find_chain_state(clip, 0, true);
  figure.skeleton = clip.skeleton;
  figure.model = make_gymnast_model();
  return figure;
}

// Also where the second axis is turned by more than a right angle, which Euler's angles would say with a third.
TEST(PassiveChain, BeginsAtAnyTwoAngles) {
  for (const std::string letters : {"XY", "XZ", "YX", "YZ", "ZX", "ZY"}) {
    for (int step = 0; step < 13 * 13; ++step) {
      Figure figure = make_rods({1.0, 1.0}, 0.4, letters);
      const auto axis = [&](std::size_t i) { return static_cast<Axis>(letters[i] - 'X'); };
      const glm::dquat turn = axis_rotation(axis(0), 30.0 * (step / 13 - 6)) * axis_rotation(axis(1), 30.0 * (step % 13 - 6));
      figure.state.rotations = {turn, turn};
      const PassiveChain chain = figure.let_go();
      for (const JointIndex joint : {0, 1}) {
        EXPECT_NEAR(std::abs(glm::dot(chain.rotation(joint), turn)), 1.0, 1e-14) << letters << " " << step;
      }
    }
  }
}

TEST(PassiveChain, IsTheInverseOfInverseDynamics) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    for (const bool root_held : {true, false}) {
      const Figure figure = make_random_figure(1 + static_cast<int>(seed % 9), seed, root_held);
      EXPECT_LT(largest_torque_share(figure, figure.let_go()), 1e-9) << seed << root_held;
    }
  }
}

TEST(PassiveChain, StaysItsInverseOnTheWay) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Figure figure = make_random_figure(6, seed, seed % 2 == 0);
    PassiveChain chain = figure.let_go();
    advance_by_frames(chain, 0.5);
    EXPECT_LT(largest_torque_share(figure, chain), 1e-9) << seed;
  }
}

TEST(PassiveChain, KeepsItsEnergy) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Figure figure = make_random_figure(6, seed, seed % 2 == 0);
    figure.settings.change_per_second = 1e-6;
    PassiveChain chain = figure.let_go();
    advance_by_frames(chain, 2.0);
    EXPECT_LT(chain.energy_drift(), 2e-6) << seed;
  }
  for (const std::size_t joints : {1u, 2u, 3u, 20u}) {
    Figure figure = make_rods(std::vector<double>(joints, 1.0), 0.3, "ZXY");
    figure.settings.change_per_second = joints == 20u ? 1e-6 : 1e-8;
    figure.state.rotations[0] = axis_rotation(Axis::Z, 100.0) * axis_rotation(Axis::X, 20.0);
    figure.state.angular_velocities[joints - 1] = {0.5, 1.0, 2.0};
    PassiveChain chain = figure.let_go();
    advance_by_frames(chain, 3.0);
    EXPECT_LT(chain.energy_drift(), 3.0 * figure.settings.change_per_second) << joints;
    EXPECT_LT(largest_torque_share(figure, chain), 1e-9) << joints;
  }
  PassiveChain gymnast = make_swinging_gymnast().let_go();
  advance_by_frames(gymnast, 10.0);
  EXPECT_LT(gymnast.energy_drift(), 1e-7);
}

// What is said of the energies is what mechanics says of the states.
TEST(PassiveChain, TellsItsEnergies) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Figure figure = make_random_figure(7, seed, seed % 2 == 0);
    PassiveChain chain = figure.let_go();
    advance(chain, 0.01);
    const BodyState whole = whole_of(figure, chain);
    EXPECT_NEAR(chain.kinetic_energy(), whole.kinetic_energy, 1e-11 * whole.kinetic_energy);
    EXPECT_NEAR(chain.potential_energy(), whole.potential_energy, 1e-11 * std::abs(whole.potential_energy));
  }
}

// Shared theory, section 6.3, case 7. Several roots fall as several bodies; a root that cannot turn all ways is held from it.
TEST(PassiveChain, KeepsMomentumInFlight) {
  int figures = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Figure figure = make_random_figure(6, seed, false);
    const auto& parents = figure.skeleton.parents();
    const auto euler = find_euler_channels(figure.skeleton, 0);
    if (std::count(parents.begin(), parents.end(), kNoParent) > 1 || !euler || euler->count < 3) continue;
    ++figures;
    PassiveChain chain = figure.let_go();
    const BodyState start = whole_of(figure, chain);
    const glm::dvec3& gravity = figure.settings.gravity_mps2;
    const double mass = total_mass_kg(figure.model);
    advance_by_frames(chain, 1.0);
    const BodyState end = whole_of(figure, chain);
    expect_near(end.momentum, start.momentum + mass * gravity, 1e-6 * mass, "momentum");
    expect_near(end.com, start.com + start.com_velocity + 0.5 * gravity, 1e-6, "centre of mass");
    expect_near(end.angular_momentum, start.angular_momentum, 1e-6 * glm::length(start.angular_momentum), "angular momentum");
  }
  EXPECT_GT(figures, 10);
}

// Half the step, a sixteenth of the error.
TEST(PassiveChain, IsOfFourthOrder) {
  const auto ends_at = [](const Figure& figure, int steps) {
    PassiveChain chain = figure.let_go();
    chain.advance(0.5, steps);
    return chain.world_states();
  };
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Figure figure = make_random_figure(5, seed, seed % 2 == 0);
    const auto exact = ends_at(figure, 6400);
    const auto error_of = [&](int steps) {
      const auto found = ends_at(figure, steps);
      double squared = 0.0;
      for (std::size_t i = 0; i < found.size(); ++i) {
        const glm::dvec3 away = found[i].position - exact[i].position;
        const glm::dquat turned = found[i].rotation - exact[i].rotation;
        squared += glm::dot(away, away) + glm::dot(turned, turned);
      }
      return std::sqrt(squared);
    };
    const double ratio = error_of(200) / error_of(400);
    EXPECT_GT(ratio, 14.0) << seed;
    EXPECT_LT(ratio, 18.0) << seed;
  }
}

// Hands without mass stay as they are; so do joints with rotations that are no Euler angles, and positions.
TEST(PassiveChain, KeepsWhatNothingMoves) {
  Figure figure = make_rods({1.0, 1.0, 1.0, 1.0}, 0.4, "ZXY");
  const glm::dquat bent = axis_rotation(Axis::X, 30.0);
  figure.model.segments.resize(3);
  figure.state.rotations = {axis_rotation(Axis::Z, 70.0), bent, bent, bent};
  figure.state.angular_velocities[3] = {1.0, 2.0, 3.0};
  PassiveChain chain = figure.let_go();
  advance_by_frames(chain, 1.0);
  EXPECT_EQ(chain.rotation(3), bent);
  EXPECT_NE(chain.rotation(2), bent);
  EXPECT_EQ(chain.position(2), figure.state.positions[2]);
  EXPECT_EQ(chain.position(0), glm::dvec3(0.0));
  const std::vector<JointState> states = chain.world_states();
  expect_near(states[3].angular_velocity, states[2].angular_velocity, 0.0, "with the arm");
  EXPECT_LT(chain.energy_drift(), 1e-7);

  Figure odd = make_rods({1.0, 1.0}, 0.4, "XXZ");
  odd.state.rotations[0] = bent;
  PassiveChain rigid = odd.let_go();
  advance_by_frames(rigid, 1.0);
  EXPECT_EQ(rigid.rotation(0), bent);
}

// Upright and hanging at rest nothing begins to move.
TEST(PassiveChain, RestsInBalance) {
  for (const double angle_deg : {0.0, 180.0}) {
    Figure figure = make_rods({1.0, 2.0, 3.0}, 0.5, "ZXY");
    figure.state.rotations[0] = axis_rotation(Axis::Z, angle_deg);
    PassiveChain chain = figure.let_go();
    advance_by_frames(chain, 1.0);
    EXPECT_EQ(chain.kinetic_energy(), 0.0);
    EXPECT_EQ(chain.energy_drift(), 0.0);
    EXPECT_EQ(chain.rotation(0), figure.state.rotations[0]);
  }
}

TEST(PassiveChain, RefusesWhatCannotMove) {
  Figure figure = make_rods({1.0}, 1.0, "Z");
  figure.model.segments[0].mass_kg = 0.0;
  figure.model.segments[0].inertia_kgm2 = glm::dmat3(0.0);
  const auto code_of = [&] {
    const auto chain = PassiveChain::make(figure.skeleton, figure.model, figure.state, figure.settings);
    return chain ? DiagnosticCode{} : chain.error().code;
  };
  EXPECT_EQ(code_of(), DiagnosticCode::InvalidArgument);
  figure.model.segments[0].mass_kg = 1.0;
  figure.state.angular_velocities[0].z = std::numeric_limits<double>::infinity();
  EXPECT_EQ(code_of(), DiagnosticCode::NotFinite);
  EXPECT_EQ(find_chain_state(make_gymnast(), 23, false).error().message, "The clip has 23 frames; there is no frame 24 to let go at.");
  Clip gap = make_gymnast();
  gap.motion.channel_samples(3)[5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(find_chain_state(gap, 5, false).error().code, DiagnosticCode::NotFinite);
  EXPECT_TRUE(find_chain_state(gap, 12, true));
}

// What is too fast is told, and the chain is where it was.
TEST(PassiveChain, SaysThatItRunsAway) {
  Figure figure = make_rods({1.0, 1.0}, 1.0, "Z");
  figure.state.angular_velocities[1].z = 1e7;
  PassiveChain chain = figure.let_go();
  EXPECT_EQ(chain.advance(0.1).error().code, DiagnosticCode::InvalidArgument);
  EXPECT_EQ(chain.rotation(1), glm::dquat(1.0, 0.0, 0.0, 0.0));
}

TEST(PassiveMotion, HasFramesAndCanBeStopped) {
  const Figure figure = make_swinging_gymnast();
  std::vector<double> shares;
  const auto motion = find_passive_motion(figure.let_go(), 0.02, 50, [&](double share) {
    shares.push_back(share);
    return true;
  });
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->frame_count(), 50);
  EXPECT_EQ(motion->rotations.size(), 150u);
  EXPECT_EQ(motion->root_positions, std::vector<glm::dvec3>(50, glm::dvec3(0.0)));
  EXPECT_EQ(shares.size(), 50u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1.0);
  PassiveChain chain = figure.let_go();
  const double start = chain.kinetic_energy() + chain.potential_energy();
  for (int frame = 0; frame < 50; ++frame) advance(chain, 0.02);
  EXPECT_EQ(motion->rotations[149], chain.rotation(2));
  EXPECT_NEAR(motion->kinetic_energies[49] + motion->potential_energies[49], start, 1e-7 * start);
  EXPECT_EQ(motion->energy_drift, chain.energy_drift());
  const auto stopped = find_passive_motion(figure.let_go(), 0.02, 50, [](double share) { return share < 0.5; });
  EXPECT_EQ(stopped.error().code, DiagnosticCode::Cancelled);
}

}  // namespace
}  // namespace marey::test
