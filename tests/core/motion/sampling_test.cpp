#include "core/motion/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/math/euler.h"
#include "tests/core/kinematics/figures.h"

namespace marey {
namespace {

TEST(FrameBlend, LiesBetweenTwoFrames) {
  const FrameBlend at = find_frame_blend(10, 3.25);
  EXPECT_EQ(at.frame, 3);
  EXPECT_EQ(at.next, 4);
  EXPECT_EQ(at.weight, 0.25);
}

TEST(FrameBlend, IsOneFrameOnWholeNumbersAndOutside) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<double, FrameIndex> cases[] = {{0.0, 0}, {7.0, 7}, {9.0, 9}, {9.5, 9}, {1e300, 9}, {-0.5, 0}, {nan, 0}};
  for (const auto& [frame, expected] : cases) {
    const FrameBlend at = find_frame_blend(10, frame);
    EXPECT_EQ(at.frame, expected) << frame;
    EXPECT_EQ(at.next, expected) << frame;
    EXPECT_EQ(at.weight, 0.0) << frame;
  }
}

TEST(SampleAt, IsLinearAndExactOnFrames) {
  Motion motion(1, 2, 0.1);
  motion.channel_samples(0)[0] = 0.1;
  motion.channel_samples(0)[1] = 0.7;
  EXPECT_EQ(sample_at(motion, 0, find_frame_blend(2, 0.0)), 0.1);
  EXPECT_DOUBLE_EQ(sample_at(motion, 0, find_frame_blend(2, 0.5)), 0.4);
  EXPECT_EQ(sample_at(motion, 0, find_frame_blend(2, 1.0)), 0.7);
  motion.channel_samples(0)[1] = HUGE_VAL;
  EXPECT_EQ(sample_at(motion, 0, find_frame_blend(2, 0.0)), 0.1);
}

TEST(JointRotation, TakesOnlyRotationsInTheirOrder) {
  const Skeleton skeleton =
      figures::make_skeleton({{"joint", kNoParent, {}, figures::channels("YxZsX?"), {}}});
  const Motion motion = figures::make_motion({{10.0, 99.0, 20.0, 99.0, 30.0, 99.0}}, 0.1);
  const std::vector<Axis> axes = {Axis::Y, Axis::Z, Axis::X};
  const std::vector<double> angles_deg = {10.0, 20.0, 30.0};
  EXPECT_EQ(joint_rotation(skeleton, motion, 0, 0), rotation_from_euler(axes, angles_deg));
}

TEST(JointRotation, OfNoChannelsIsNone) {
  const Skeleton skeleton = figures::make_skeleton({{"joint", kNoParent, {}, {}, {}}});
  EXPECT_EQ(joint_rotation(skeleton, Motion(0, 2, 0.1), 0, 1), glm::dquat(1.0, 0.0, 0.0, 0.0));
}

}  // namespace
}  // namespace marey
