#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/math/angle.h"
#include "core/motion/euler_channels.h"
#include "core/motion/sampling.h"
#include "tests/core/editing/operation_clips.h"

namespace marey::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double largest_step(const Clip& clip, ChannelIndex channel) {
  const std::span<const double> samples = clip.motion.channel_samples(channel);
  double largest = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) largest = std::max(largest, std::abs(samples[i] - samples[i - 1]));
  return largest;
}

TEST(Unroll, TakesWholeTurnsOutAndIsIdempotent) {
  Random random(21);
  for (int round = 0; round < 20; ++round) {
    const Clip clip = make_wild_figure(random, 50);
    const Clip unrolled = after(clip, "unroll");
    EXPECT_LT(largest_difference(positions_of(clip), positions_of(unrolled)), 1e-9);
    EXPECT_TRUE(outcome_of(unrolled, "unroll", whole_clip(unrolled)).edit.empty());
    for (ChannelIndex channel = 3; channel < clip.motion.channel_count(); ++channel) {
      EXPECT_LE(largest_step(unrolled, channel), 180.0);
      EXPECT_EQ(unrolled.motion.sample(channel, 0), clip.motion.sample(channel, 0));
    }
    for (ChannelIndex channel = 0; channel < 3; ++channel) EXPECT_EQ(samples_of(unrolled, channel), samples_of(clip, channel));
  }
}

TEST(Unroll, GoesOnFromTheFrameBeforeTheRange) {
  const Clip clip = make_clip_with_curve({350, 355, 0, 5, 10});
  const Clip unrolled = after(clip, "unroll", target_of(clip, {kCurve}, {2, 3}));
  EXPECT_THAT(samples_of(unrolled, kCurve), testing::ElementsAre(350, 355, 360, 365, 370));
}

TEST(Unroll, PassesOverMissingSamples) {
  const Clip clip = make_clip_with_curve({170, kNan, -170});
  EXPECT_EQ(after(clip, "unroll").motion.sample(kCurve, 2), 190.0);
}

// The reference sheet's example: ZXY (10, 100, 20) is canonically (-170, 80, -160); beside (12, 95, 18) it is itself.
TEST(SolveAngles, TakesTheSolutionNearTheFrameBefore) {
  Clip clip = make_clip_with_curve({12, -170});
  clip.motion.channel_samples(4)[0] = 95;
  clip.motion.channel_samples(5)[0] = 18;
  clip.motion.channel_samples(4)[1] = 80;
  clip.motion.channel_samples(5)[1] = -160;
  const Clip solved = after(clip, "solve-angles");
  EXPECT_NEAR(solved.motion.sample(3, 1), 10.0, 1e-9);
  EXPECT_NEAR(solved.motion.sample(4, 1), 100.0, 1e-9);
  EXPECT_NEAR(solved.motion.sample(5, 1), 20.0, 1e-9);
}

TEST(SolveAngles, KeepsThePosesAndStartsCanonically) {
  Random random(22);
  for (int round = 0; round < 20; ++round) {
    const Clip clip = make_wild_figure(random, 50);
    const Clip solved = after(clip, "solve-angles");
    EXPECT_LT(largest_difference(positions_of(clip), positions_of(solved)), 1e-9);
    EXPECT_TRUE(outcome_of(solved, "solve-angles", whole_clip(solved)).edit.empty());
    const Clip canonical = after(clip, "solve-angles", {{"start", choice_of("solve-angles", "start", "canonical")}});
    EXPECT_LT(largest_difference(positions_of(clip), positions_of(canonical)), 1e-9);
    EXPECT_LE(std::abs(canonical.motion.sample(4, 0)), 90.0 + 1e-9);
  }
}

TEST(SolveAngles, IsNotWorseThanWhatItGets) {
  Random random(23);
  const Clip clip = make_wild_figure(random, 200);
  const Clip solved = after(clip, "solve-angles");
  for (ChannelIndex channel = 3; channel < 6; ++channel) EXPECT_LE(largest_step(solved, channel), largest_step(clip, channel));
}

// A turn at constant speed about one fixed axis has nothing to smooth, whatever its angles look like.
TEST(RotationFilter, KeepsATurnAtConstantSpeed) {
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1.0, 2.0, -0.5));
  Clip clip = make_figure(80);
  glm::dvec3 angles(0.0);
  const EulerChannels euler = *find_euler_channels(clip.skeleton, 1);
  for (int frame = 0; frame < 80; ++frame) {
    const glm::dmat3 rotation = glm::mat3_cast(glm::angleAxis(0.08 * frame, axis));
    angles = euler_near(euler.order, rotation, angles);
    for (int i = 0; i < 3; ++i) clip.motion.channel_samples(euler.channels[i])[idx(frame)] = angles[i];
  }
  for (const std::string_view method : {"gaussian", "butterworth"}) {
    const Clip filtered = after(clip, "rotation-filter", {{"method", choice_of("rotation-filter", "method", method)}, {"cutoff", 3.0}});
    for (int frame = 0; frame < 80; ++frame) {
      const glm::dquat before = joint_rotation(clip.skeleton, clip.motion, 1, frame);
      const glm::dquat now = joint_rotation(clip.skeleton, filtered.motion, 1, frame);
      EXPECT_NEAR(std::abs(glm::dot(before, now)), 1.0, 1e-9) << method << " " << frame;
    }
  }
}

TEST(RotationFilter, FiltersHingesByTheirAngle) {
  const Clip clip = make_figure(60);
  const Clip filtered = after(clip, "rotation-filter", {{"sigma", 2.0}});
  const Clip smoothed = after(clip, "smooth", {{"sigma", 2.0}});
  const ChannelIndex knee = clip.skeleton.first_channel(8);
  ASSERT_EQ(clip.skeleton.channel_count(8), 1);
  EXPECT_EQ(samples_of(filtered, knee), samples_of(smoothed, knee));
  EXPECT_EQ(samples_of(filtered, 0), samples_of(clip, 0));
}

TEST(RotationFilter, DoesNotCareForWholeTurns) {
  const Clip clip = make_figure(60);
  Clip leaping = clip;
  for (int frame = 20; frame < 60; ++frame) leaping.motion.channel_samples(7)[idx(frame)] -= 360.0;
  const Clip filtered = after(clip, "rotation-filter", {{"sigma", 3.0}});
  const Clip leaping_filtered = after(leaping, "rotation-filter", {{"sigma", 3.0}});
  EXPECT_LT(largest_difference(positions_of(filtered), positions_of(leaping_filtered)), 1e-9);
  EXPECT_GT(largest_step(leaping_filtered, 7), 300.0);
}

// Turning the whole figure and then filtering is the same as filtering and then turning it.
TEST(RotationFilter, DoesNotCareForTheAxes) {
  const Clip clip = make_figure(60);
  const auto turned = [](const Clip& c) { return after(c, "turn", {{"angle", 77.0}}); };
  const auto filtered = [](const Clip& c) { return after(c, "rotation-filter", {{"sigma", 3.0}}); };
  EXPECT_LT(largest_difference(positions_of(filtered(turned(clip))), positions_of(turned(filtered(clip)))), 1e-6);
}

TEST(Blending, OfRotationsIsBySlerp) {
  Clip clip = make_figure(10);
  OperationTarget target = whole_clip(clip);
  target.weight = 0.5;
  const Clip full = after(clip, "turn", {{"angle", 90.0}});
  const Clip half = after(clip, "turn", target, {{"angle", 90.0}});
  for (int frame = 0; frame < 10; ++frame) {
    const glm::dquat a = joint_rotation(clip.skeleton, clip.motion, 0, frame);
    const glm::dquat b = joint_rotation(clip.skeleton, full.motion, 0, frame);
    const glm::dquat mixed = joint_rotation(clip.skeleton, half.motion, 0, frame);
    EXPECT_NEAR(std::abs(glm::dot(glm::slerp(a, b, 0.5), mixed)), 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace marey::test
