#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/math/angle.h"
#include "tests/core/biomechanics/body_fixtures.h"

namespace marey::test {
namespace {

constexpr double kRate_hz = 400.0;

AnalysisTable gymnast_table(std::vector<std::string> quantities, double frame_time_s = 0.033333) {
  AnalysisRequest request;
  request.quantities = std::move(quantities);
  request.model = make_gymnast_model();
  request.support = SupportKind::Pivot;
  request.frame_time_s = frame_time_s;
  return table_of(make_gymnast(), request);
}

glm::dvec3 at(const AnalysisTable& table, std::string_view label, std::string_view unit, FrameIndex frame) {
  glm::dvec3 value;
  for (int c = 0; c < 3; ++c) {
    value[c] = column_of(table, std::string(label) + "." + "xyz"[c] + "[" + std::string(unit) + "]")[idx(frame)];
  }
  return value;
}

/// Three ball joints with a travelling root, all of them turning, in metres.
Clip make_tumbling() {
  const Skeleton skeleton = figures::make_skeleton({{"Hips", kNoParent, glm::dvec3(0.0), figures::channels("xyzZXY"), {}},
                                                    {"Chest", 0, {0.1, 0.5, 0}, figures::channels("ZXY"), {}},
                                                    {"Arm", 1, {0.3, 0.2, -0.1}, figures::channels("YXZ"), {glm::dvec3(0.4, 0, 0)}}});
  return make_moving(skeleton, 40, kRate_hz, [](FrameIndex frame, ChannelIndex channel) {
    const double t = frame / kRate_hz;
    return channel < 3 ? 0.7 * std::sin(3.0 * t + channel) : 50.0 * std::sin((2.0 + 0.4 * channel) * t + channel);
  });
}

AnalysisTable tumbling_table(std::vector<std::string> quantities) {
  AnalysisRequest request;
  request.quantities = std::move(quantities);
  request.model = make_random_model(make_tumbling().skeleton, 7);
  request.support = SupportKind::Flight;
  return table_of(make_tumbling(), request);
}

// Shared theory, sections 7.2 and 7.3.
TEST(Analysis, PathsWorkAndEnergyOfTheGiantSwing) {
  const AnalysisTable table = gymnast_table({"path_length:*", "work:*", "energy"}, 0.066667);
  EXPECT_NEAR(column_of(table, "path_length:Body[m]").back(), 60.278630 * 0.055, 1e-6);
  EXPECT_NEAR(column_of(table, "path_length:Legs[m]").back(), 130.417491 * 0.055, 1e-6);
  EXPECT_NEAR(column_of(table, "path_length:Legs_end[m]").back(), 224.261905 * 0.055, 1e-6);
  // The table has torque by angle, here it is power by time; both by trapezoids.
  EXPECT_NEAR(column_of(table, "work:Body[J]")[21], 162.1, 0.7);
  EXPECT_NEAR(column_of(table, "work:Legs[J]")[21], -15.7, 0.4);
  const auto& energy = column_of(table, "energy[J]");
  EXPECT_NEAR(*std::min_element(energy.begin() + 1, energy.end() - 1), 745.2, 0.05);
  EXPECT_NEAR(*std::max_element(energy.begin() + 1, energy.end() - 1), 1030.1, 0.05);
}

TEST(Analysis, AnglesOfTheGiantSwing) {
  const AnalysisTable table = gymnast_table({"included_angle:*", "plane_angle:*", "plane_angle:Legs@parent", "rotation_angle:*", "rotation_axis:*",
                                                        "angle:Legs@world", "angle_rate:Arms", "angular_velocity:Legs@parent", "angle_rate:Legs"});
  EXPECT_TRUE(std::isnan(column_of(table, "included_angle:Arms[rad]")[0]));
  EXPECT_NEAR(column_of(table, "included_angle:Body[rad]")[0], to_radians(180.0 - 7.0), 1e-9);
  EXPECT_NEAR(column_of(table, "included_angle:Legs[rad]")[11], to_radians(180.0 - 11.1), 1e-9);
  EXPECT_NEAR(column_of(table, "plane_angle:Arms.z[rad]")[0], to_radians(90.0 + 16.6), 1e-9);
  EXPECT_NEAR(column_of(table, "plane_angle:Arms.z[rad]")[22], to_radians(90.0 + 363.3), 1e-9);
  EXPECT_NEAR(column_of(table, "plane_angle:Legs@parent.z[rad]")[11], to_radians(90.0 - 11.1), 1e-9);
  EXPECT_NEAR(column_of(table, "rotation_angle:Arms[rad]")[11], to_radians(360.0 - 205.5), 1e-9);
  EXPECT_NEAR(at(table, "rotation_axis:Arms", "1", 11).z, -1.0, 1e-12);
  EXPECT_NEAR(column_of(table, "rotation_angle:Legs[rad]")[0], to_radians(2.7), 1e-9);
  EXPECT_NEAR(at(table, "angle:Legs@world", "rad", 22).z, to_radians(363.3 + 4.1 + 1.9), 1e-9);
  EXPECT_NEAR(column_of(table, "angle_rate:Arms.z[rad/s]")[9], to_radians(651.0065), 1e-6);
  for (FrameIndex frame = 1; frame < 22; ++frame) {
    EXPECT_NEAR(at(table, "angular_velocity:Legs@parent", "rad/s", frame).z, column_of(table, "angle_rate:Legs.z[rad/s]")[idx(frame)], 1e-9);
  }
}

TEST(FrameOfReference, APointThatIsFixedToItStandsStill) {
  const AnalysisTable table = tumbling_table({"position:Arm+0.1/-0.2/0.3@Arm", "velocity:Arm+0.1/-0.2/0.3@Arm", "position:Arm+0.4/0/0",
                                              "position:Arm_end", "position:Hips@root", "segment_com:Hips@Hips", "segment_com_acceleration:Arm@Arm"});
  for (FrameIndex frame = 1; frame < 39; ++frame) {
    EXPECT_LT(glm::distance(at(table, "position:Arm+0.1/-0.2/0.3@Arm", "m", frame), {0.1, -0.2, 0.3}), 1e-12);
    EXPECT_LT(glm::length(at(table, "velocity:Arm+0.1/-0.2/0.3@Arm", "m/s", frame)), 1e-9);
    EXPECT_LT(glm::distance(at(table, "position:Arm+0.4/0/0", "m", frame), at(table, "position:Arm_end", "m", frame)), 1e-12);
    EXPECT_LT(glm::length(at(table, "position:Hips@root", "m", frame)), 1e-12);
    EXPECT_LT(glm::distance(at(table, "segment_com:Hips@Hips", "m", frame), at(table, "segment_com:Hips@Hips", "m", 0)), 1e-12);
    EXPECT_LT(glm::length(at(table, "segment_com_acceleration:Arm@Arm", "m/s2", frame)), 1e-9);
  }
}

// What is seen changes as its own derivative says.
TEST(FrameOfReference, DerivativesAreThoseOfWhatIsSeen) {
  const std::vector<std::string> frames = {"", "@Chest", "@Hips", "@parent"};
  for (const std::string& seen : frames) {
    std::vector<std::string> quantities = {"segment_com:Arm" + seen, "segment_com_velocity:Arm" + seen, "segment_com_acceleration:Arm" + seen,
                                           "position:Arm_end" + seen, "velocity:Arm_end" + seen};
    const AnalysisTable table = tumbling_table(quantities);
    for (FrameIndex frame = 2; frame < 38; ++frame) {
      const auto place = [&](int step) { return at(table, quantities[0], "m", frame + step); };
      const glm::dvec3 velocity = (place(1) - place(-1)) * (0.5 * kRate_hz);
      const glm::dvec3 acceleration = (place(1) - 2.0 * place(0) + place(-1)) * (kRate_hz * kRate_hz);
      EXPECT_LT(glm::distance(velocity, at(table, quantities[1], "m/s", frame)), 1e-3) << seen;
      EXPECT_LT(glm::distance(acceleration, at(table, quantities[2], "m/s2", frame)), 1e-2) << seen;
      const glm::dvec3 end = (at(table, quantities[3], "m", frame + 1) - at(table, quantities[3], "m", frame - 1)) * (0.5 * kRate_hz);
      EXPECT_LT(glm::distance(end, at(table, quantities[4], "m/s", frame)), 1e-9) << seen;
    }
  }
}

// The derivative of a relative angular velocity, in the axes of the frame, is the relative angular acceleration.
TEST(FrameOfReference, AngularVelocitiesAreRelative) {
  const AnalysisTable table = tumbling_table({"angular_velocity:Arm@Hips", "angular_acceleration:Arm@Hips", "angular_velocity:Arm", "angular_velocity:Hips",
                                              "torque:Arm", "torque:Arm@Chest", "com", "com@Arm", "com_velocity@Arm"});
  for (FrameIndex frame = 2; frame < 38; ++frame) {
    const auto spin = [&](int step) { return at(table, "angular_velocity:Arm@Hips", "rad/s", frame + step); };
    EXPECT_LT(glm::distance((spin(1) - spin(-1)) * (0.5 * kRate_hz), at(table, "angular_acceleration:Arm@Hips", "rad/s2", frame)), 2e-2);
    EXPECT_NEAR(glm::length(spin(0)), glm::distance(at(table, "angular_velocity:Arm", "rad/s", frame), at(table, "angular_velocity:Hips", "rad/s", frame)), 1e-9);
    EXPECT_NEAR(glm::length(at(table, "torque:Arm", "N.m", frame)), glm::length(at(table, "torque:Arm@Chest", "N.m", frame)), 1e-9);
    const glm::dvec3 seen = (at(table, "com@Arm", "m", frame + 1) - at(table, "com@Arm", "m", frame - 1)) * (0.5 * kRate_hz);
    EXPECT_LT(glm::distance(seen, at(table, "com_velocity@Arm", "m/s", frame)), 1e-3);
  }
}

// Nothing that is seen from a joint changes when the whole figure is put elsewhere and turned.
TEST(FrameOfReference, DoesNotKnowWhereTheFigureStands) {
  const std::vector<std::string> quantities = {"position:Arm_end@Hips", "velocity:Arm_end@Hips", "angle:Arm@Hips"};
  Clip there = make_tumbling();
  for (ChannelIndex channel = 0; channel < 3; ++channel) {
    for (double& sample : there.motion.channel_samples(channel)) sample += 10.0 * (channel + 1);
  }
  for (double& sample : there.motion.channel_samples(3)) sample += 120.0;
  AnalysisRequest request;
  request.quantities = quantities;
  const AnalysisTable here = table_of(make_tumbling(), request);
  const AnalysisTable moved = table_of(there, request);
  for (std::size_t c = 0; c < here.columns.size(); ++c) {
    for (std::size_t i = 1; i < 39; ++i) EXPECT_NEAR(here.columns[c].values[i], moved.columns[c].values[i], 1e-9) << here.columns[c].name;
  }
}

TEST(FrameOfReference, ZeroMomentPointIsTheCentreOfPressureWhereTheGroundPresses) {
  AnalysisRequest request;
  request.quantities = {"cop", "zmp"};
  request.model = make_random_model(make_tumbling().skeleton, 7);
  request.support = SupportKind::Ground;
  const AnalysisTable table = table_of(make_tumbling(), request);
  int pressed = 0;
  for (FrameIndex frame = 1; frame < 39; ++frame) {
    const glm::dvec3 pressure = at(table, "cop", "m", frame);
    if (std::isnan(pressure.x)) continue;
    ++pressed;
    EXPECT_LT(glm::distance(pressure, at(table, "zmp", "m", frame)), 1e-9);
  }
  EXPECT_GT(pressed, 5);
}

TEST(AskedQuantity, SaysWhatCannotBeAsked) {
  const Clip clip = make_tumbling();
  const auto message_of = [&](const std::string& text) {
    const auto asked = find_quantities(clip.skeleton, std::span(&text, 1));
    return asked ? std::string() : asked.error().message;
  };
  EXPECT_EQ(message_of("position:Arm@Leg"), "'Leg' is no frame of reference: a joint, world, root or parent.");
  EXPECT_EQ(message_of("position:Leg@Arm"), "There is no joint 'Leg@Arm' and no such end site.");
  EXPECT_EQ(message_of("position:Arm+1/2"), "'+1/2' is not a point: write +X/Y/Z, in metres.");
  EXPECT_EQ(message_of("position:Arm+1/2/x"), "'+1/2/x' is not a point: write +X/Y/Z, in metres.");
  EXPECT_EQ(message_of("position:Arm_end+1/2/3"), "'position:Arm_end' has no point fixed to it, so '+1/2/3' cannot stand behind it: only places of joints do.");
  EXPECT_EQ(message_of("power:Arm@Hips"), "'power' is the same in every frame of reference; '@Hips' cannot stand behind it.");
  EXPECT_EQ(message_of("com@parent"), "'parent' is no frame of reference: a joint, world or root.");
  EXPECT_EQ(message_of("position:*+0/0/0.1@root"), "");
  EXPECT_EQ(message_of("com@"), "'' is no frame of reference: a joint, world or root.");
  EXPECT_EQ(message_of("position:*@root"), "");
  EXPECT_EQ(message_of("com@Hips"), "");
}

TEST(AskedQuantity, KnowsJointsWithoutNamesAndWithSigns) {
  const Skeleton skeleton = figures::make_skeleton({{"", kNoParent, glm::dvec3(0.0), figures::channels("ZXY"), {}},
                                                    {"a@b", 0, {0, 1, 0}, figures::channels("Z"), {}}});
  const auto ask = [&](const std::string& text) { return find_quantities(skeleton, std::span(&text, 1)); };
  EXPECT_FALSE(ask("com@"));
  EXPECT_FALSE(ask("position:a@b@"));
  const auto found = ask("torque:a@b@a@b");
  ASSERT_TRUE(found);
  EXPECT_EQ((*found)[0].node, 1);
  EXPECT_EQ((*found)[0].frame, 1);
  EXPECT_EQ((*ask("position:*@a@b"))[0].frame, 1);
}

TEST(AskedQuantity, TakesNamesWholeFirst) {
  const Skeleton skeleton = figures::make_skeleton({{"a:b", kNoParent, glm::dvec3(0.0), figures::channels("ZXY"), {}},
                                                    {"c@a:b", 0, {0, 1, 0}, figures::channels("Z"), {}},
                                                    {"root", 1, {0, 1, 0}, figures::channels("Z"), {}},
                                                    {"d+1/2/3", 2, {0, 1, 0}, figures::channels("Z"), {}}});
  const std::vector<std::string> texts = {"position:c@a:b", "position:root@a:b", "com@a:b", "position:a:b@root", "position:d+1/2/3", "position:d+1/2/3+4/5/6"};
  const auto asked = find_quantities(skeleton, texts);
  ASSERT_TRUE(asked);
  ASSERT_EQ(asked->size(), 6u);
  EXPECT_EQ((*asked)[0].node, 1);
  EXPECT_FALSE((*asked)[0].frame);
  EXPECT_EQ((*asked)[1].frame, 0);
  EXPECT_EQ((*asked)[2].frame, 0);
  EXPECT_EQ((*asked)[3].frame, 2);
  EXPECT_EQ((*asked)[4].point_m, glm::dvec3(0.0));
  EXPECT_EQ((*asked)[5].point_m, glm::dvec3(4, 5, 6));
  EXPECT_EQ((*asked)[5].label, "position:d+1/2/3+4/5/6");
}

}  // namespace
}  // namespace marey::test
