#include "core/kinematics/pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/math/euler.h"
#include "tests/core/kinematics/figures.h"

namespace marey {
namespace {

using figures::channels;

LocalPose pose_between(const Skeleton& skeleton, const Motion& motion, double frame) {
  LocalPose local;
  local.resize(skeleton);
  compute_local_pose_between(skeleton, motion, frame, PositionRule::Replace, local);
  return local;
}

LocalPose pose_at(const Skeleton& skeleton, const Motion& motion, FrameIndex frame) {
  LocalPose local;
  local.resize(skeleton);
  compute_local_pose(skeleton, motion, frame, PositionRule::Replace, local);
  return local;
}

bool same(const LocalPose& a, const LocalPose& b) {
  return a.local_translations == b.local_translations && a.local_rotations == b.local_rotations;
}

// Degrees between two rotations, by the shorter way.
double angle_between_deg(const glm::dquat& a, const glm::dquat& b) {
  const glm::dquat difference = glm::conjugate(a) * b;
  const glm::dvec3 axis(difference.x, difference.y, difference.z);
  return 2.0 * glm::degrees(std::atan2(glm::length(axis), std::abs(difference.w)));
}

class PoseBetween : public testing::Test {
 protected:
  Skeleton skeleton = figures::make_random_skeleton(30, 5);
  Motion motion = figures::make_random_motion(skeleton, 6, 200.0, 6);
};

TEST_F(PoseBetween, OnWholeFramesIsTheFramesOwn) {
  for (FrameIndex frame = 0; frame < motion.frame_count(); ++frame) {
    EXPECT_TRUE(same(pose_between(skeleton, motion, frame), pose_at(skeleton, motion, frame)));
  }
}

TEST_F(PoseBetween, OutsideTheClipIsItsFirstOrLastFrame) {
  for (double before : {-1e300, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(same(pose_between(skeleton, motion, before), pose_at(skeleton, motion, 0)));
  }
  for (double after : {5.0, 5.01, 1e300}) {
    EXPECT_TRUE(same(pose_between(skeleton, motion, after), pose_at(skeleton, motion, 5)));
  }
}

TEST_F(PoseBetween, HasUnitRotations) {
  for (double frame = 0.0; frame < 5.0; frame += 0.17) {
    for (const glm::dquat& rotation : pose_between(skeleton, motion, frame).local_rotations) {
      EXPECT_NEAR(glm::length(rotation), 1.0, 4e-16);
    }
  }
}

TEST_F(PoseBetween, TurnsBallJointsEvenlyByTheShortWay) {
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    if (euler_order_label(skeleton, joint).size() < 2) continue;
    const auto rotation_at = [&](double frame) { return pose_between(skeleton, motion, frame).local_rotations[idx(joint)]; };
    const double whole_deg = angle_between_deg(rotation_at(2.0), rotation_at(3.0));
    for (double part : {0.25, 0.5, 0.75}) {
      EXPECT_NEAR(angle_between_deg(rotation_at(2.0), rotation_at(2.0 + part)), part * whole_deg, 1e-9);
    }
  }
}

TEST(PoseBetweenFrames, TurnsHingesByTheirAngleAndMovesPositionsOnALine) {
  const Skeleton skeleton = figures::make_skeleton({{"crank", kNoParent, {}, channels("xZ"), {{1.0, 0.0, 0.0}}}});
  const Motion motion = figures::make_motion({{1.0, 10.0}, {3.0, 290.0}}, 0.1);
  const LocalPose local = pose_between(skeleton, motion, 0.5);
  EXPECT_EQ(local.local_translations[0], glm::dvec3(2.0, 0.0, 0.0));
  EXPECT_LT(angle_between_deg(local.local_rotations[0], axis_rotation(Axis::Z, 150.0)), 1e-12);
}

TEST(PoseBetweenFrames, LosesOnlyTheJointThatIsNotANumber) {
  const Skeleton skeleton = figures::make_skeleton(
      {{"a", kNoParent, {}, channels("ZXY"), {}}, {"b", 0, {1.0, 0.0, 0.0}, channels("ZXY"), {}}});
  Motion motion(6, 2, 0.1);
  motion.channel_samples(4)[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(std::isnan(pose_between(skeleton, motion, 0.0).local_rotations[1].w));
  const LocalPose local = pose_between(skeleton, motion, 0.5);
  EXPECT_FALSE(std::isnan(local.local_rotations[0].w));
  EXPECT_TRUE(std::isnan(local.local_rotations[1].w));
}

TEST(WorldPoseOfAClip, TurnsChildrenNotTheJointItself) {
  const Skeleton skeleton = figures::make_gymnast();
  Motion motion(skeleton.channel_count(), 1, 0.1);
  motion.channel_samples(3)[0] = 90.0;
  WorldPose world;
  world.resize(skeleton);
  compute_world_pose(skeleton, pose_at(skeleton, motion, 0), world);
  EXPECT_EQ(world.world_positions[0], glm::dvec3(0.0));
  EXPECT_LT(glm::distance(world.world_positions[1], glm::dvec3(-10.0, 0.0, 0.0)), 1e-14);
  EXPECT_LT(glm::distance(world.world_positions[3], glm::dvec3(-38.0, 0.0, 0.0)), 1e-13);
  EXPECT_LT(angle_between_deg(world.world_rotations[2], axis_rotation(Axis::Z, 90.0)), 1e-13);
}

TEST(WorldPoseOfAClip, LocalRotationsComeBackFromWorldRotations) {
  const Skeleton skeleton = figures::make_random_skeleton(50, 9);
  const Motion motion = figures::make_random_motion(skeleton, 1, 180.0, 10);
  const LocalPose local = pose_at(skeleton, motion, 0);
  WorldPose world;
  world.resize(skeleton);
  compute_world_pose(skeleton, local, world);
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const JointIndex parent = skeleton.parent(joint);
    const glm::dquat above = parent == kNoParent ? glm::dquat(1.0, 0.0, 0.0, 0.0) : world.world_rotations[idx(parent)];
    const glm::dquat back = glm::conjugate(above) * world.world_rotations[idx(joint)];
    EXPECT_LT(angle_between_deg(back, local.local_rotations[idx(joint)]), 1e-12);
  }
}

TEST(SeveralRoots, StandEachInTheWorld) {
  const Skeleton skeleton = figures::make_skeleton({{"one", kNoParent, {1.0, 0.0, 0.0}, channels("Z"), {}},
                                                    {"two", kNoParent, {0.0, 5.0, 0.0}, channels("Z"), {{2.0, 0.0, 0.0}}}});
  const auto found = figures::positions_of(skeleton, figures::make_motion({{45.0, 90.0}}, 0.1), PositionRule::Replace);
  EXPECT_EQ(found[0][0], glm::dvec3(1.0, 0.0, 0.0));
  EXPECT_EQ(found[0][1], glm::dvec3(0.0, 5.0, 0.0));
  EXPECT_LT(glm::distance(found[0][2], glm::dvec3(0.0, 7.0, 0.0)), 1e-15);
}

}  // namespace
}  // namespace marey
