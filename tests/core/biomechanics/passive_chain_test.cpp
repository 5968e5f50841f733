#include "core/biomechanics/passive_chain.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/math/angle.h"
#include "core/math/euler.h"
#include "tests/core/biomechanics/chain_fixtures.h"

namespace marey::test {
namespace {

constexpr double kG = 9.81;

void expect_near(const glm::dvec3& found, const glm::dvec3& expected, double within, const char* what) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], within) << what << "." << "xyz"[i];
}

void advance(PassiveChain& chain, double seconds) {
  const Status status = chain.advance(seconds);
  ASSERT_TRUE(status.ok()) << status.error().message;
}

/// The angle about z of the first joint, and how fast it grows.
struct Swing {
  double angle = 0.0;
  double speed = 0.0;
};

Swing swing_of(const PassiveChain& chain) {
  const JointState state = chain.world_states()[0];
  return {2.0 * std::atan2(state.rotation.z, state.rotation.w), state.angular_velocity.z};
}

/// When the first joint passes `angle`, whole turns aside: between two frames by the angle's own speed.
double find_passing_s(PassiveChain& chain, double angle, double frame_s) {
  const auto distance = [&] { return std::remainder(swing_of(chain).angle - angle, 2.0 * std::numbers::pi); };
  double before = distance();
  for (int frame = 1; frame < 100000; ++frame) {
    advance(chain, frame_s);
    const double now = distance();
    if (before * now < 0.0 && std::abs(now) < 1.0) return frame * frame_s - now / swing_of(chain).speed;
    before = now;
  }
  ADD_FAILURE() << "does not get there";
  return 0.0;
}

// Shared theory, section 6.3, case 2.
TEST(PassiveChain, PeriodsOfAPendulum) {
  for (const auto& [angle_deg, ratio] : {std::pair(10.0, 1.0019072), {90.0, 1.1803406}, {170.0, 2.4393627}}) {
    Figure figure = make_rods({2.0}, 1.0, "Z");
    figure.state.rotations[0] = axis_rotation(Axis::Z, angle_deg);
    PassiveChain chain = figure.let_go();
    const double small_s = 2.0 * std::numbers::pi * std::sqrt(2.0 / (3.0 * kG));
    EXPECT_NEAR(4.0 * find_passing_s(chain, 0.0, 1e-4) / small_s, ratio, 1e-7) << angle_deg;
  }
}

// Case 1: from upright to the bottom, nearly from rest.
TEST(PassiveChain, ARodFromUpright) {
  constexpr double kSpeed = 1e-3;
  for (const double length : {1.0, 2.09}) {
    Figure figure = make_rods({3.0}, length, "ZXY");
    figure.state.rotations[0] = axis_rotation(Axis::Z, 180.0);
    figure.state.angular_velocities[0].z = kSpeed;
    PassiveChain chain = figure.let_go();
    find_passing_s(chain, 0.0, 1e-4);
    EXPECT_NEAR(swing_of(chain).speed, std::sqrt(6.0 * kG / length), 1e-6);
    std::vector<JointLoad> loads(1);
    find_joint_loads(body_of(chain), figure.skeleton, figure.model, figure.settings.gravity_mps2, 0, {}, loads);
    EXPECT_NEAR(loads[0].force.y, 4.0 * 3.0 * kG, 1e-4);
  }
}

// Section 6.4: fixture D with a straight body.
TEST(PassiveChain, AStiffGymnastOnTheBar) {
  Skeleton skeleton = figures::make_skeleton({{"Arms", kNoParent, glm::dvec3(0.0), figures::channels("Z"), {}},
                                              {"Body", 0, {0.0, 0.55, 0.0}, {}, {}},
                                              {"Legs", 1, {0.0, 0.66, 0.0}, {}, {}}});
  Figure figure = make_figure(skeleton, make_gymnast_model());
  figure.state.angular_velocities[0].z = 1e-3;
  PassiveChain resting = figure.let_go();
  find_passing_s(resting, std::numbers::pi, 1e-4);
  EXPECT_NEAR(swing_of(resting).speed, 5.660, 5e-4);
  std::vector<JointLoad> loads(3);
  find_joint_loads(body_of(resting), figure.skeleton, figure.model, figure.settings.gravity_mps2, 0, {}, loads);
  EXPECT_NEAR(loads[0].force.y / (70.0 * kG), 4.24, 5e-3);
  for (const auto& [speed, seconds] : {std::pair(0.5, 2.69), {1.0, 2.19}, {1.5, 1.90}, {2.0, 1.69}}) {
    figure.state.angular_velocities[0].z = speed;
    PassiveChain chain = figure.let_go();
    const double half_s = find_passing_s(chain, std::numbers::pi, 1e-3);
    EXPECT_NEAR(2.0 * half_s, seconds, 5e-3) << speed;
  }
}

// Case 5: no torque, three moments.
TEST(PassiveChain, ABodyInSpace) {
  Figure figure = make_top(1.0, glm::dvec3(0.0), {1.0, 2.0, 3.0});
  figure.settings = {false, glm::dvec3(0.0), 1e-8};
  figure.state.angular_velocities[0] = {0.5, 0.0, 1.0};
  figure.state.velocities[0] = {1.0, 2.0, 3.0};
  PassiveChain chain = figure.let_go();
  const auto own_turning = [&] {
    const JointState state = chain.world_states()[0];
    return glm::conjugate(state.rotation) * state.angular_velocity;
  };
  advance(chain, 1.0);
  expect_near(own_turning(), {0.27490861, 0.41764250, 0.97049382}, 2e-8, "after 1 s");
  advance(chain, 2.0);
  expect_near(own_turning(), {-0.48899751, 0.10431413, 0.99818478}, 2e-8, "after 3 s");
  advance(chain, 6.4206003 - 3.0);
  expect_near(own_turning(), {0.5, 0.0, 1.0}, 1e-6, "after a period");
  expect_near(chain.position(0), 6.4206003 * glm::dvec3(1.0, 2.0, 3.0), 1e-9, "place");
}

// Case 5: two equal moments: the axis goes round the angular momentum.
TEST(PassiveChain, ASymmetricBodyInSpace) {
  Figure figure = make_top(1.0, glm::dvec3(0.0), {1.0, 1.0, 2.0});
  figure.settings = {false, glm::dvec3(0.0), 1e-8};
  figure.state.angular_velocities[0] = {0.3, 0.0, 5.0};
  PassiveChain chain = figure.let_go();
  const glm::dvec3 momentum = glm::normalize(glm::dvec3(0.3, 0.0, 10.0));
  for (int second = 1; second < 4; ++second) {
    advance(chain, 1.0);
    const glm::dvec3 axis = glm::angleAxis(10.0044990 * second, momentum) * glm::dvec3(0.0, 0.0, 1.0);
    expect_near(chain.world_states()[0].rotation * glm::dvec3(0.0, 0.0, 1.0), axis, 1e-7, "axis");
  }
}

// Case 6: the slow precession of a heavy top, whose axis leans by an angle from upright.
TEST(PassiveChain, AHeavyTop) {
  for (const auto& [lean_deg, precession] : {std::pair(90.0, 2.4525), {60.0, 2.55004}}) {
    Figure figure = make_top(1.0, {0.0, 0.1, 0.0}, {0.002, 0.002, 0.002});
    const glm::dquat lean = axis_rotation(Axis::Z, -lean_deg);
    const glm::dvec3 axis = lean * glm::dvec3(0.0, 1.0, 0.0);
    figure.state.rotations[0] = lean;
    // 200 rad/s about its own axis in all.
    const double spin = 200.0 - precession * axis.y;
    figure.state.angular_velocities[0] = spin * axis + glm::dvec3(0.0, precession, 0.0);
    PassiveChain chain = figure.let_go();
    advance(chain, 0.5);
    const glm::dvec3 expected = axis_rotation(Axis::Y, to_degrees(0.5 * precession)) * axis;
    expect_near(chain.world_states()[0].rotation * glm::dvec3(0.0, 1.0, 0.0), expected, 5e-6, "axis");
  }
}

/// Angles from hanging and their speeds.
using Double = std::array<double, 4>;

// Lagrange's equations of two uniform rods, masses and lengths of case 3, absolute angles.
Double rates_of(const Double& y) {
  constexpr double m1 = 2.0, m2 = 1.5, l1 = 0.5, l2 = 0.4;
  const double c = 0.5 * m2 * l1 * l2 * std::cos(y[0] - y[1]);
  const double s = 0.5 * m2 * l1 * l2 * std::sin(y[0] - y[1]);
  const double a = (m1 / 3.0 + m2) * l1 * l1;
  const double b = m2 * l2 * l2 / 3.0;
  const double p = -s * y[3] * y[3] - (0.5 * m1 + m2) * kG * l1 * std::sin(y[0]);
  const double q = s * y[2] * y[2] - 0.5 * m2 * kG * l2 * std::sin(y[1]);
  const double d = a * b - c * c;
  return {y[2], y[3], (b * p - c * q) / d, (a * q - c * p) / d};
}

Double integrated(Double y, double seconds, int steps) {
  const double h = seconds / steps;
  const auto plus = [](Double to, const Double& rate, double time) {
    for (std::size_t i = 0; i < 4; ++i) to[i] += time * rate[i];
    return to;
  };
  for (int step = 0; step < steps; ++step) {
    const Double a = rates_of(y);
    const Double b = rates_of(plus(y, a, 0.5 * h));
    const Double c = rates_of(plus(y, b, 0.5 * h));
    const Double d = rates_of(plus(y, c, h));
    for (std::size_t i = 0; i < 4; ++i) y[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
  }
  return y;
}

// Hinges, and balls that have no reason to leave the plane, against the closed form.
TEST(PassiveChain, ADoublePendulum) {
  for (const std::string channels : {"Z", "ZXY", "ZX"}) {
    Figure figure = make_rods({2.0, 1.5}, 0.5, channels);
    figure.model.segments[1] = {1, 1.5, {0.0, -0.2, 0.0}, glm::dmat3(1.5 * 0.16 / 12.0)};
    figure.state.rotations = {axis_rotation(Axis::Z, 120.0), axis_rotation(Axis::Z, -50.0)};
    figure.state.angular_velocities[1].z = 1.0;
    PassiveChain chain = figure.let_go();
    Double expected = {to_radians(120.0), to_radians(70.0), 0.0, 1.0};
    for (int second = 1; second <= 3; ++second) {
      advance(chain, 1.0);
      expected = integrated(expected, 1.0, 20000);
      const std::vector<JointState> states = chain.world_states();
      for (std::size_t i = 0; i < 2; ++i) {
        const double angle = 2.0 * std::atan2(states[i].rotation.z, states[i].rotation.w);
        EXPECT_NEAR(std::remainder(angle - expected[i], 2.0 * std::numbers::pi), 0.0, 2e-6) << channels << second;
        EXPECT_NEAR(states[i].angular_velocity.z, expected[2 + i], 2e-5) << channels << second;
        EXPECT_EQ(states[i].angular_velocity.x, 0.0);
        EXPECT_EQ(states[i].angular_velocity.y, 0.0);
      }
    }
  }
}

}  // namespace
}  // namespace marey::test
