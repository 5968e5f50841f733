#include "core/kinematics/clip_bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "tests/core/kinematics/figures.h"

namespace marey {
namespace {

using figures::channels;

// Turns the y axis into `up`, so that one description serves both habits.
glm::dvec3 stood(const glm::dvec3& p, Axis up) { return up == Axis::Y ? p : glm::dvec3(p.x, -p.z, p.y); }

// A person of 170 in T-pose whose root is the hip.
Skeleton make_person(Axis up) {
  const auto at = [up](double x, double y, double z) { return stood({x, y, z}, up); };
  return figures::make_skeleton({{"hip", kNoParent, {}, channels("xyzZXY"), {}},
                                 {"left leg", 0, at(10, 0, 0), channels("ZXY"), {at(0, -90, 5)}},
                                 {"right leg", 0, at(-10, 0, 0), channels("ZXY"), {at(0, -90, 5)}},
                                 {"back", 0, at(0, 50, 0), channels("ZXY"), {at(80, 0, 0), at(-80, 0, 0), at(0, 30, 0)}}});
}

// Four-legged, longer than tall.
Skeleton make_quadruped(Axis up) {
  const auto at = [up](double x, double y, double z) { return stood({x, y, z}, up); };
  return figures::make_skeleton(
      {{"body", kNoParent, {}, channels("xyzZXY"), {at(0, 0, 70), at(10, -50, 40), at(-10, -50, 40), at(10, -50, -40)}}});
}

// The root walks over the ground at the given height.
Motion make_walk(const Skeleton& skeleton, Axis up, double height) {
  Motion motion(skeleton.channel_count(), 100, 1.0 / 30.0);
  for (FrameIndex i = 0; i < 100; ++i) {
    const glm::dvec3 root = stood({0.1 * i, height + std::sin(0.3 * i), 4.0 * i}, up);
    for (int axis = 0; axis < 3; ++axis) motion.channel_samples(axis)[idx(i)] = root[axis];
  }
  return motion;
}

class EitherUpAxis : public testing::TestWithParam<Axis> {};
INSTANTIATE_TEST_SUITE_P(Axes, EitherUpAxis, testing::Values(Axis::Y, Axis::Z));

TEST_P(EitherUpAxis, IsFoundForAWalkingPerson) {
  const Skeleton person = make_person(GetParam());
  EXPECT_EQ(find_up_axis(person, make_walk(person, GetParam(), 92.0), PositionRule::Replace), GetParam());
}

TEST_P(EitherUpAxis, IsFoundForASinglePoseAndForNone) {
  const Skeleton person = make_person(GetParam());
  EXPECT_EQ(find_up_axis(person, Motion(person.channel_count(), 1, 0.1), PositionRule::Replace), GetParam());
  EXPECT_EQ(find_up_axis(person, Motion(person.channel_count(), 0, 0.1), PositionRule::Replace), GetParam());
}

TEST_P(EitherUpAxis, IsFoundForAnAnimalThatIsLongerThanTall) {
  const Skeleton animal = make_quadruped(GetParam());
  EXPECT_EQ(find_up_axis(animal, make_walk(animal, GetParam(), 51.0), PositionRule::Replace), GetParam());
}

TEST_P(EitherUpAxis, HasTheGroundUnderTheFeet) {
  const Skeleton person = make_person(GetParam());
  const Motion single(person.channel_count(), 1, 0.1);
  EXPECT_EQ(find_ground_height(person, single, PositionRule::Replace, GetParam()), -90.0);
  EXPECT_EQ(find_ground_height(person, make_walk(person, GetParam(), 92.0), PositionRule::Replace, GetParam()), 0.0);
  EXPECT_NEAR(find_ground_height(person, make_walk(person, GetParam(), 500.0), PositionRule::Replace, GetParam()), 409.0,
              0.5);
}

TEST(UpAxis, IsYWhereNothingSpeaksForEither) {
  const Skeleton point = figures::make_skeleton({{"point", kNoParent, {}, channels("xyz"), {}}});
  EXPECT_EQ(find_up_axis(point, Motion(3, 5, 0.1), PositionRule::Replace), Axis::Y);
  const Skeleton cube = figures::make_skeleton({{"cube", kNoParent, {}, {}, {{1.0, 1.0, 1.0}}}});
  EXPECT_EQ(find_up_axis(cube, Motion(0, 5, 0.1), PositionRule::Replace), Axis::Y);
}

TEST(UpAxis, OfTheGiantSwingIsY) {
  EXPECT_EQ(find_up_axis(figures::make_gymnast(), figures::make_giant_swing(), PositionRule::Replace), Axis::Y);
}

TEST(GroundHeight, IsZeroForASwingAroundTheOrigin) {
  EXPECT_EQ(find_ground_height(figures::make_gymnast(), figures::make_giant_swing(), PositionRule::Replace, Axis::Y), 0.0);
}

TEST(GroundHeight, IsNotSunkByOneBadFrame) {
  const Skeleton person = make_person(Axis::Y);
  Motion walk = make_walk(person, Axis::Y, 500.0);
  walk.channel_samples(1)[99] = -1e6;
  EXPECT_NEAR(find_ground_height(person, walk, PositionRule::Replace, Axis::Y), 409.0, 0.5);
}

TEST(ClipBounds, HoldEveryNodeOfEveryFrame) {
  const Skeleton skeleton = figures::make_random_skeleton(30, 4);
  const Motion motion = figures::make_random_motion(skeleton, 50, 90.0, 5);
  glm::dvec3 low(HUGE_VAL);
  glm::dvec3 high(-HUGE_VAL);
  for (const auto& frame : figures::positions_of(skeleton, motion, PositionRule::Replace)) {
    for (const glm::dvec3& p : frame) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  const Box box = compute_clip_bounds(skeleton, motion, PositionRule::Replace);
  EXPECT_LT(glm::distance(box.low, low), 1e-10);
  EXPECT_LT(glm::distance(box.high, high), 1e-10);
}

TEST(ClipBounds, TakeFirstAndLastFrameOfFewSamples) {
  const Skeleton point = figures::make_skeleton({{"point", kNoParent, {}, channels("x"), {}}});
  const Motion motion = figures::make_motion({{-3.0}, {90.0}, {0.0}, {0.0}, {7.0}}, 0.1);
  const Box box = compute_clip_bounds(point, motion, PositionRule::Replace, 2);
  EXPECT_EQ(box.low.x, -3.0);
  EXPECT_EQ(box.high.x, 7.0);
}

TEST(ClipBounds, LeaveOutWhatIsNotFinite) {
  const Skeleton point = figures::make_skeleton({{"point", kNoParent, {4.0, 5.0, 6.0}, channels("x"), {}}});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Box some = compute_clip_bounds(point, figures::make_motion({{1.0}, {nan}, {HUGE_VAL}}, 0.1), PositionRule::Replace);
  EXPECT_EQ(some.high.x, 1.0);
  const Box none = compute_clip_bounds(point, figures::make_motion({{nan}}, 0.1), PositionRule::Replace);
  EXPECT_EQ(none.low, glm::dvec3(4.0, 5.0, 6.0));
  EXPECT_EQ(compute_clip_bounds(point, Motion(1, 0, 0.1), PositionRule::Replace).high, glm::dvec3(4.0, 5.0, 6.0));
}

}  // namespace
}  // namespace marey
