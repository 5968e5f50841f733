#include "core/biomechanics/mechanics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/biomechanics/support.h"
#include "core/math/angle.h"
#include "core/math/euler.h"
#include "tests/core/biomechanics/body_fixtures.h"

namespace marey::test {
namespace {

const glm::dvec3 kGravity(0.0, -9.81, 0.0);

void expect_near(const glm::dvec3& found, const glm::dvec3& expected, double within, const char* what) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], within) << what << "." << "xyz"[i];
}

/// A motion of one frame with these states.
BodyMotion make_body(std::vector<JointState> states) {
  BodyMotion body;
  body.joint_count = size_of(states);
  body.frame_count = 1;
  body.frame_time_s = 0.01;
  body.metres_per_unit = 1.0;
  body.states = std::move(states);
  return body;
}

BodyMotion motion_of(const Clip& clip, std::string_view method = "central") {
  const Result<BodyMotion> body = find_body_motion(clip, *parse_derivation(method), clip.motion.frame_time_s(), 1.0);
  EXPECT_TRUE(body);
  return *body;
}

Skeleton make_chain(int joints, const std::string& letters) {
  std::vector<figures::JointPlan> plan;
  for (int i = 0; i < joints; ++i) {
    plan.push_back({"J" + std::to_string(i), i - 1, glm::dvec3(0.0, i == 0 ? 0.0 : 1.0, 0.0), figures::channels(letters), {}});
  }
  plan.back().end_sites = {glm::dvec3(0.0, 1.0, 0.0)};
  return figures::make_skeleton(plan);
}

Segment make_segment(JointIndex joint, double mass, const glm::dvec3& com, const std::array<double, 6>& moments) {
  return {joint, mass, com, symmetric_tensor(moments)};
}

std::vector<JointLoad> loads_of(const BodyMotion& body, const Skeleton& skeleton, const BodyModel& model, FrameIndex frame,
                                const glm::dvec3& gravity = kGravity, std::span<const OuterForce> outer = {}) {
  std::vector<JointLoad> loads(idx(body.joint_count));
  find_joint_loads(body, skeleton, model, gravity, frame, outer, loads);
  return loads;
}

// Shared theory, section 6.3, case 4, found alike by MuJoCo.
TEST(JointLoads, OfABodyOnABallJoint) {
  JointState state;
  state.rotation = rotation_from_euler({Axis::Z, Axis::X, Axis::Y}, {30, 20, 10});
  state.angular_velocity = {1, -2, 3};
  state.angular_acceleration = {-4, 5, 6};
  const BodyMotion body = make_body({state});
  BodyModel model;
  model.segments = {make_segment(0, 2.0, {0.1, 0.3, -0.05}, {0.04, 0.02, 0.05, 0, 0, 0})};
  const auto loads = loads_of(body, make_chain(1, "ZXY"), model, 0);
  expect_near(loads[0].force, {-2.36100116, 12.68798191, -6.27720718}, 1e-8, "force");
  expect_near(loads[0].torque, {-2.63068315, -0.53593950, 0.01061989}, 1e-8, "torque");
  expect_near(glm::conjugate(state.rotation) * loads[0].torque, {-2.45870445, 0.80350267, -0.71902272}, 1e-8, "torque in the body");
  const BodyState whole = find_body_state(body, model, kGravity, 0);
  EXPECT_NEAR(whole.kinetic_energy, 1.43768991, 1e-8);
  EXPECT_NEAR(whole.potential_energy, 6.05800511, 1e-8);
  expect_near(angular_momentum_about(whole, glm::dvec3(0.0)), {0.16078153, -0.12647811, 0.82054736}, 1e-8, "angular momentum");
}

// Case 3: found alike by KDL. Angles from the horizontal, so the links lie along x.
TEST(JointLoads, OfADoublePendulum) {
  const std::array<double, 2> q = {0.4, -0.7};
  const std::array<double, 2> velocity = {1.2, -2.1};
  const std::array<double, 2> acceleration = {0.5, 3.0};
  JointState first;
  first.rotation = axis_rotation(Axis::Z, to_degrees(q[0]));
  first.angular_velocity.z = velocity[0];
  first.angular_acceleration.z = acceleration[0];
  JointState second = state_of_point(first, {0.5, 0, 0});
  second.rotation = axis_rotation(Axis::Z, to_degrees(q[0] + q[1]));
  second.angular_velocity.z = velocity[0] + velocity[1];
  second.angular_acceleration.z = acceleration[0] + acceleration[1];
  BodyModel model;
  model.segments = {make_segment(0, 2.0, {0.25, 0, 0}, {0, 0, 2.0 * 0.25 / 12, 0, 0, 0}),
                    make_segment(1, 1.5, {0.2, 0, 0}, {0, 0, 1.5 * 0.16 / 12, 0, 0, 0})};
  const auto loads = loads_of(make_body({first, second}), make_chain(2, "Z"), model, 0);
  EXPECT_NEAR(loads[0].torque.z, 15.0549258, 1e-7);
  EXPECT_NEAR(loads[1].torque.z, 3.0097674, 1e-7);
  EXPECT_NEAR(loads[1].power, 3.0097674 * velocity[1], 1e-6);
}

// Case 1: a rod that swings from upright to the bottom, from rest: four times its weight at the pivot, and no torque.
TEST(JointLoads, OfAPassiveRod) {
  constexpr double kMass = 3.0;
  BodyModel model;
  model.segments = {make_segment(0, kMass, {0, 0.5, 0}, {0, 0, kMass / 12.0, 0, 0, 0})};
  for (const double angle : {0.0, 0.7, 2.0, std::numbers::pi}) {
    JointState state;
    state.rotation = axis_rotation(Axis::Z, to_degrees(angle));
    state.angular_velocity.z = std::sqrt(3.0 * 9.81 * (1.0 - std::cos(angle)));
    state.angular_acceleration.z = 1.5 * 9.81 * std::sin(angle);
    const auto loads = loads_of(make_body({state}), make_chain(1, "Z"), model, 0);
    EXPECT_NEAR(loads[0].torque.z, 0.0, 1e-12);
    const glm::dvec3 along(-std::sin(angle), std::cos(angle), 0.0);
    EXPECT_NEAR(glm::dot(loads[0].force, along), -kMass * 9.81 * (1.5 - 2.5 * std::cos(angle)), 1e-9) << angle;
  }
}

// Case 8: power is the change of energy, with the angles of a closed form.
TEST(JointLoads, PowerIsTheChangeOfEnergy) {
  constexpr double kRate_hz = 4000.0;
  Clip clip = make_gymnast();
  const auto angle_at = [](double t, int link) {
    if (link == 0) return 0.3 + 3.0 * t + 0.2 * std::sin(4.0 * t);
    return link == 1 ? 0.1 + 0.3 * std::sin(3.0 * t) : -0.2 + 0.4 * std::cos(5.0 * t);
  };
  for (const auto& [t, torques, force, kinetic, potential] :
       {std::tuple(0.25, glm::dvec3(-1025.33008, -468.31579, -120.28733), glm::dvec3(915.80283, 775.86670, 0), 523.799716, 144.920461),
        std::tuple(1.0, glm::dvec3(208.40876, 140.08859, 21.09630), glm::dvec3(118.47609, 1070.93036, 0), 0.0, 0.0)}) {
    Motion motion(12, 3, 1.0 / kRate_hz);
    for (FrameIndex frame = 0; frame < 3; ++frame) {
      for (int link = 0; link < 3; ++link) {
        motion.channel_samples(3 + 3 * link)[idx(frame)] = to_degrees(angle_at(t + (frame - 1) / kRate_hz, link));
      }
    }
    clip.motion = motion;
    const BodyModel model = make_gymnast_model();
    const BodyMotion body = *find_body_motion(clip, {}, 1.0 / kRate_hz, 0.055);
    const auto loads = loads_of(body, clip.skeleton, model, 1);
    for (int link = 0; link < 3; ++link) EXPECT_NEAR(loads[idx(link)].torque.z, torques[link], 5e-3) << t;
    expect_near(loads[0].force, force, 5e-3, "force");
    if (kinetic == 0.0) continue;
    const BodyState state = find_body_state(body, model, kGravity, 1);
    EXPECT_NEAR(state.kinetic_energy, kinetic, 1e-3);
    EXPECT_NEAR(state.potential_energy, potential, 1e-6);
    EXPECT_NEAR(loads[0].power + loads[1].power + loads[2].power, -3599.274471, 0.05);
  }
}

// Case 5: a symmetric body without torque, I = (1, 1, 2), (0.3, 0, 5) rad/s: Rz(10.0044990 t) Rx(1.7183580 deg) Rz(-5 t).
TEST(JointLoads, AFreeTopNeedsNone) {
  constexpr double kRate_hz = 1000.0;
  const Skeleton skeleton = make_chain(1, "ZXZ");
  const Clip clip = make_moving(skeleton, 400, kRate_hz, [](FrameIndex frame, ChannelIndex channel) {
    const double t = frame / kRate_hz;
    return channel == 0 ? to_degrees(10.0044990 * t) : channel == 1 ? 1.7183580 : to_degrees(-5.0 * t);
  });
  BodyModel model;
  model.segments = {make_segment(0, 1.0, {0, 0, 0}, {1, 1, 2, 0, 0, 0})};
  const BodyMotion body = motion_of(clip);
  for (FrameIndex frame = 1; frame + 1 < body.frame_count; frame += 7) {
    expect_near(find_body_state(body, model, glm::dvec3(0.0), frame).angular_momentum, {0, 0, 10.0044990}, 1e-4, "angular momentum");
    expect_near(loads_of(body, skeleton, model, frame, glm::dvec3(0.0))[0].torque, glm::dvec3(0.0), 1e-3, "torque");
  }
}

Clip make_random_clip(unsigned seed, int frames, double rate_hz) {
  const Skeleton skeleton = figures::make_random_skeleton(7, seed);
  return make_moving(skeleton, frames, rate_hz, [=](FrameIndex frame, ChannelIndex channel) {
    return 20.0 * std::sin(3.0 * frame / rate_hz + 1.3 * channel + seed) + 0.1 * channel;
  });
}

// What all roots are given is what the body as a whole needs: Newton and Euler for the whole.
TEST(JointLoads, AtTheRootsAreThoseOfTheWholeBody) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Clip clip = make_random_clip(seed, 9, 60.0);
    const BodyModel model = make_random_model(clip.skeleton, seed);
    const BodyMotion body = motion_of(clip);
    const BodyState state = find_body_state(body, model, kGravity, 4);
    const auto loads = loads_of(body, clip.skeleton, model, 4);
    glm::dvec3 force(0.0);
    glm::dvec3 moment(0.0);
    for (JointIndex joint = 0; joint < body.joint_count; ++joint) {
      if (clip.skeleton.parent(joint) != kNoParent) continue;
      force += loads[idx(joint)].force;
      moment += loads[idx(joint)].torque + glm::cross(body.state(4, joint).position, loads[idx(joint)].force);
    }
    const glm::dvec3 needed = total_mass_kg(model) * (state.com_acceleration - kGravity);
    const double size = glm::length(needed) + glm::length(moment);
    expect_near(force, needed, 1e-11 * size, "force");
    expect_near(moment, state.angular_momentum_rate + glm::cross(state.com, needed), 1e-10 * size, "moment");
  }
}

// However the ground's force is shared out, nothing is left for the root to be held by.
TEST(Support, TheGroundTakesAllOfIt) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    Clip clip = make_random_clip(seed, 9, 60.0);
    if (std::count(clip.skeleton.parents().begin(), clip.skeleton.parents().end(), kNoParent) > 1) continue;
    const BodyModel model = make_random_model(clip.skeleton, seed);
    const BodyMotion body = motion_of(clip);
    Contacts contacts = find_contacts(body, clip.skeleton, Axis::Y);
    for (std::size_t i = 0; i < contacts.down.size(); ++i) contacts.down[i] = i % 3 != 1 ? 1 : 0;
    const BodyState state = find_body_state(body, model, kGravity, 4);
    const GroundReaction reaction = find_ground_reaction(state, total_mass_kg(model), kGravity, Axis::Y, contacts.floor_m);
    if (!contacts.any_down(4)) continue;
    const auto outer = share_out(reaction, state, body, contacts, 4);
    const auto loads = loads_of(body, clip.skeleton, model, 4, kGravity, outer);
    const double size = glm::length(reaction.force) * 10.0;
    expect_near(loads[0].force, glm::dvec3(0.0), 1e-11 * size, "force");
    expect_near(loads[0].torque, glm::dvec3(0.0), 1e-10 * size, "torque");
  }
}

/// A body of a hip and two legs of one joint each, which stands still.
Clip make_standing() {
  const Skeleton skeleton =
      figures::make_skeleton({{"Hips", kNoParent, glm::dvec3(0.0), figures::channels("xyzZXY"), {}},
                              {"Left", 0, glm::dvec3(0.2, 0, 0), figures::channels("ZXY"), {glm::dvec3(0, -1, 0)}},
                              {"Right", 0, glm::dvec3(-0.2, 0, 0), figures::channels("ZXY"), {glm::dvec3(0, -1, 0)}}});
  return make_moving(skeleton, 20, 30.0, [](FrameIndex, ChannelIndex channel) { return channel == 1 ? 1.0 : 0.0; });
}

TEST(Support, OfABodyThatStands) {
  const Clip clip = make_standing();
  BodyModel model;
  model.segments = {make_segment(0, 40.0, {0.05, 0.3, 0.02}, {1, 1, 1, 0, 0, 0})};
  const BodyMotion body = motion_of(clip);
  const Contacts contacts = find_contacts(body, clip.skeleton, Axis::Y);
  EXPECT_NEAR(contacts.floor_m, 0.0, 1e-12);
  EXPECT_EQ(contacts.points.size(), 2u);
  EXPECT_TRUE(contacts.is_down(10, 0) && contacts.is_down(10, 1));
  const BodyState state = find_body_state(body, model, kGravity, 10);
  const GroundReaction reaction = find_ground_reaction(state, 40.0, kGravity, Axis::Y, contacts.floor_m);
  expect_near(reaction.force, {0, 392.4, 0}, 1e-9, "reaction");
  expect_near(reaction.centre_of_pressure, {0.05, 0.0, 0.02}, 1e-12, "centre of pressure");
  const auto outer = share_out(reaction, state, body, contacts, 10);
  ASSERT_EQ(outer.size(), 2u);
  const double left = std::hypot(0.15, 0.02);
  const double right = std::hypot(0.25, 0.02);
  EXPECT_NEAR(outer[0].force.y, 392.4 * right / (left + right), 1e-9);
  EXPECT_NEAR(outer[1].force.y, 392.4 * left / (left + right), 1e-9);
}

TEST(Support, FlightLeavesNoResidual) {
  constexpr double kRate_hz = 120.0;
  const Skeleton skeleton = make_chain(3, "xyzZXY");
  Clip clip = make_moving(skeleton, 40, kRate_hz, [](FrameIndex frame, ChannelIndex channel) {
    const double t = frame / kRate_hz;
    if (channel == 1) return 1.0 + 3.0 * t - 0.5 * 9.81 * t * t;
    return channel == 0 ? 2.0 * t : channel == 7 || channel == 13 ? 1.0 : 0.0;
  });
  AnalysisRequest request;
  request.quantities = {"force:J0", "torque:J0", "reaction", "momentum", "cop"};
  request.model = make_random_model(skeleton, 3);
  for (const SupportKind support : {SupportKind::Flight, SupportKind::Auto}) {
    request.support = support;
    const AnalysisTable table = table_of(clip, request);
    for (const char* name : {"force:J0.x[N]", "force:J0.y[N]", "torque:J0.z[N.m]"}) EXPECT_NEAR(column_of(table, name)[20], 0.0, 1e-8) << name;
    EXPECT_EQ(column_of(table, "reaction.y[N]")[20], 0.0);
    EXPECT_TRUE(std::isnan(column_of(table, "cop.x[m]")[20]));
    EXPECT_NEAR(column_of(table, "momentum.x[kg.m/s]")[20], 2.0 * total_mass_kg(*request.model), 1e-9);
  }
}

// Neither the unit of the file nor the order of its channels is a matter of mechanics.
TEST(Mechanics, IsTheSameInOtherUnits) {
  Clip metres = make_random_clip(5, 12, 60.0);
  const BodyModel model = make_random_model(metres.skeleton, 5);
  AnalysisRequest request;
  request.quantities = {"torque:*", "com", "angular_momentum", "acceleration:*", "reaction"};
  request.model = model;
  request.support = SupportKind::Pivot;
  const AnalysisTable expected = table_of(metres, request);
  Clip centimetres = metres;
  for (NodeIndex node = 0; node < metres.skeleton.node_count(); ++node) {
    centimetres.skeleton.set_offset(node, 100.0 * metres.skeleton.node(node).offset);
  }
  for (ChannelIndex channel = 0; channel < metres.motion.channel_count(); ++channel) {
    if (!is_position(metres.skeleton.channel(channel).kind)) continue;
    for (double& sample : centimetres.motion.channel_samples(channel)) sample *= 100.0;
  }
  centimetres.settings.metres_per_unit = 0.01;
  const AnalysisTable found = table_of(centimetres, request);
  ASSERT_EQ(found.columns.size(), expected.columns.size());
  for (std::size_t i = 0; i < found.columns.size(); ++i) {
    for (FrameIndex frame = 1; frame < 11; ++frame) {
      const double value = expected.columns[i].values[idx(frame)];
      EXPECT_NEAR(found.columns[i].values[idx(frame)], value, 1e-8 * (1.0 + std::abs(value))) << found.columns[i].name;
    }
  }
}

TEST(BodyModel, RefusesWhatNoBodyHas) {
  const Skeleton skeleton = make_chain(2, "Z");
  BodyModel model;
  model.segments = {make_segment(0, 1.0, {0, 0, 0}, {1, 1, 1, 0, 0, 0})};
  EXPECT_TRUE(check_body_model(model, skeleton));
  model.segments[0].inertia_kgm2 = symmetric_tensor(std::array{1.0, 1.0, 1.0, 1.5, 0.0, 0.0});
  EXPECT_FALSE(check_body_model(model, skeleton));
  model.segments[0] = make_segment(2, 1.0, {0, 0, 0}, {1, 1, 1, 0, 0, 0});
  EXPECT_FALSE(check_body_model(model, skeleton));
  model.segments[0] = make_segment(1, -1.0, {0, 0, 0}, {1, 1, 1, 0, 0, 0});
  EXPECT_FALSE(check_body_model(model, skeleton));
  model.segments[0] = make_segment(1, 1.0, {0, std::nan(""), 0}, {1, 1, 1, 0, 0, 0});
  EXPECT_FALSE(check_body_model(model, skeleton));
}

}  // namespace
}  // namespace marey::test
