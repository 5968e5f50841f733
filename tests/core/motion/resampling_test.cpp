#include "core/motion/resampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/kinematics/pose.h"
#include "tests/core/kinematics/figures.h"

namespace marey {
namespace {

using figures::channels;

double largest_difference(const WorldPose& a, const WorldPose& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.world_positions.size(); ++i) {
    largest = std::max(largest, glm::distance(a.world_positions[i], b.world_positions[i]));
  }
  return largest;
}

WorldPose world_pose_between(const Skeleton& skeleton, const Motion& motion, double frame) {
  LocalPose local;
  WorldPose world;
  local.resize(skeleton);
  world.resize(skeleton);
  compute_local_pose_between(skeleton, motion, frame, PositionRule::Replace, local);
  compute_world_pose(skeleton, local, world);
  return world;
}

// A body of joints with one and with three rotation channels, in smooth motion.
Skeleton make_body() {
  return figures::make_skeleton({{"root", kNoParent, {}, channels("xyzZXY"), {}},
                                 {"hinge", 0, {0.0, 5.0, 0.0}, channels("Z"), {}},
                                 {"proper", 1, {0.0, 5.0, 0.0}, channels("ZXZ"), {}},
                                 {"ball", 2, {3.0, 5.0, 0.0}, channels("YXZ"), {{1.0, 2.0, 3.0}}}});
}

Motion make_smooth_motion(const Skeleton& skeleton, int frame_count, double frame_time_s) {
  Motion motion(skeleton.channel_count(), frame_count, frame_time_s);
  for (ChannelIndex channel = 0; channel < motion.channel_count(); ++channel) {
    for (FrameIndex i = 0; i < frame_count; ++i) {
      motion.channel_samples(channel)[idx(i)] = 30.0 * std::sin(0.2 * i + channel) + 40.0;
    }
  }
  return motion;
}

TEST(Resampled, AtItsOwnRateIsTheSameMotion) {
  const Skeleton skeleton = figures::make_random_skeleton(30, 1);
  Motion motion = figures::make_random_motion(skeleton, 20, 300.0, 2);
  motion.set_frame_time_s(0.0083333);
  const Motion same = resampled(skeleton, motion, 120.0).value();
  EXPECT_EQ(same.frame_time_s(), 0.0083333);
  EXPECT_TRUE(std::equal(same.samples().begin(), same.samples().end(), motion.samples().begin(), motion.samples().end()));
}

TEST(Resampled, KeepsTheSamplesOfFramesThatCoincide) {
  const Skeleton skeleton = figures::make_random_skeleton(30, 3);
  Motion motion = figures::make_random_motion(skeleton, 41, 300.0, 4);
  motion.set_frame_time_s(0.0083333);
  const Motion quarter = resampled(skeleton, motion, 30.0).value();
  ASSERT_EQ(quarter.frame_count(), 11);
  EXPECT_EQ(quarter.frame_time_s(), 1.0 / 30.0);
  const Motion third = resampled(skeleton, motion, 360.0).value();
  ASSERT_EQ(third.frame_count(), 121);
  for (ChannelIndex channel = 0; channel < motion.channel_count(); ++channel) {
    for (FrameIndex i = 0; i <= 10; ++i) EXPECT_EQ(quarter.sample(channel, i), motion.sample(channel, 4 * i));
    for (FrameIndex i = 0; i <= 40; ++i) EXPECT_EQ(third.sample(channel, 3 * i), motion.sample(channel, i));
  }
}

TEST(Resampled, ShowsThePosesOfTheOriginalAtThatTime) {
  const Skeleton skeleton = make_body();
  const Motion motion = make_smooth_motion(skeleton, 30, 1.0 / 24.0);
  for (double rate_hz : {23.976, 25.0, 60.0, 10.0}) {
    const Motion other = resampled(skeleton, motion, rate_hz).value();
    EXPECT_EQ(other.frame_count(), static_cast<int>(29.0 * rate_hz / 24.0 + 1e-9) + 1);
    for (FrameIndex i = 0; i < other.frame_count(); ++i) {
      const WorldPose expected = world_pose_between(skeleton, motion, i * 24.0 / rate_hz);
      EXPECT_LT(largest_difference(world_pose_between(skeleton, other, i), expected), 1e-9) << rate_hz << " Hz, " << i;
    }
  }
}

TEST(Resampled, KeepsCurvesContinuous) {
  const Skeleton skeleton = make_body();
  const Motion motion = make_smooth_motion(skeleton, 60, 1.0 / 30.0);
  const Motion other = resampled(skeleton, motion, 100.0).value();
  for (ChannelIndex channel = 0; channel < other.channel_count(); ++channel) {
    for (FrameIndex i = 1; i < other.frame_count(); ++i) {
      EXPECT_LT(std::abs(other.sample(channel, i) - other.sample(channel, i - 1)), 8.0) << channel << ", " << i;
    }
  }
}

TEST(Resampled, KeepsCountOfTurns) {
  const Motion swing = figures::make_giant_swing();
  const Motion faster = resampled(figures::make_gymnast(), swing, 90.0).value();
  ASSERT_EQ(faster.frame_count(), 67);
  EXPECT_EQ(faster.sample(3, 66), 363.3);
  for (FrameIndex i = 1; i < 67; ++i) {
    EXPECT_GT(faster.sample(3, i), faster.sample(3, i - 1)) << i;
    EXPECT_NEAR(faster.sample(4, i), 0.0, 1e-12);
  }
}

TEST(Resampled, GoesTheShortWayThroughAWrappedAngle) {
  const Skeleton skeleton = figures::make_skeleton({{"ball", kNoParent, {}, channels("ZXY"), {}}});
  const Motion motion = figures::make_motion({{170.0, 0.0, 0.0}, {-170.0, 0.0, 0.0}}, 0.1);
  const Motion other = resampled(skeleton, motion, 40.0).value();
  ASSERT_EQ(other.frame_count(), 5);
  EXPECT_NEAR(other.sample(0, 1), 175.0, 1e-9);
  EXPECT_NEAR(other.sample(0, 3), -175.0, 1e-9);
}

TEST(Resampled, TurnsHingesByTheirAngle) {
  const Skeleton skeleton = figures::make_skeleton({{"hinge", kNoParent, {}, channels("X"), {}}});
  const Motion motion = figures::make_motion({{0.0}, {400.0}}, 0.1);
  EXPECT_EQ(resampled(skeleton, motion, 20.0).value().sample(0, 1), 200.0);
}

TEST(Resampled, KeepsUniversalJointsOnTheirTwoAxes) {
  const Skeleton skeleton = figures::make_skeleton({{"wrist", kNoParent, {}, channels("XZ"), {{0.0, 1.0, 0.0}}}});
  const Motion motion = figures::make_motion({{10.0, 175.0}, {14.0, -177.0}}, 0.1);
  const Motion other = resampled(skeleton, motion, 40.0).value();
  EXPECT_NEAR(other.sample(0, 2), 12.0, 0.1);
  EXPECT_NEAR(std::remainder(other.sample(1, 2) - 179.0, 360.0), 0.0, 0.1);
  EXPECT_EQ(other.sample(1, 4), -177.0);
}

TEST(Resampled, RefusesRatesThatAreNone) {
  const Skeleton skeleton = figures::make_gymnast();
  for (double rate_hz : {0.0, -30.0, HUGE_VAL, std::numeric_limits<double>::quiet_NaN(), 1e12, 0.1, 1e-310}) {
    const Result<Motion> result = resampled(skeleton, figures::make_giant_swing(), rate_hz);
    ASSERT_FALSE(result.has_value()) << rate_hz;
    EXPECT_EQ(result.error().code, DiagnosticCode::InvalidArgument);
  }
}

TEST(Resampled, OfNoFramesHasNone) {
  const Skeleton skeleton = figures::make_gymnast();
  EXPECT_EQ(resampled(skeleton, Motion(skeleton.channel_count(), 0, 0.1), 25.0).value().frame_count(), 0);
  EXPECT_EQ(resampled(skeleton, Motion(skeleton.channel_count(), 1, 0.1), 25.0).value().frame_count(), 1);
}

TEST(Trimmed, TakesTheFramesOfTheRange) {
  const Motion swing = figures::make_giant_swing();
  const Motion part = trimmed(swing, {4, 10});
  ASSERT_EQ(part.frame_count(), 10);
  EXPECT_EQ(part.frame_time_s(), swing.frame_time_s());
  for (ChannelIndex channel = 0; channel < swing.channel_count(); ++channel) {
    for (FrameIndex i = 0; i < 10; ++i) EXPECT_EQ(part.sample(channel, i), swing.sample(channel, i + 4));
  }
}

TEST(Trimmed, LeavesOutWhatTheMotionDoesNotHave) {
  const Motion swing = figures::make_giant_swing();
  EXPECT_EQ(trimmed(swing, {20, 10}).frame_count(), 3);
  EXPECT_EQ(trimmed(swing, {23, 1}).frame_count(), 0);
  EXPECT_EQ(trimmed(swing, {-2, 4}).frame_count(), 2);
}

}  // namespace
}  // namespace marey
