#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/editing/ground_transform.h"
#include "core/skeleton/skeleton_builder.h"
#include "tests/core/editing/operation_clips.h"

namespace marey::test {
namespace {

using testing::DoubleNear;
using testing::Each;

// All points of a clip under a transform.
std::vector<double> transformed(std::vector<double> positions, const GroundTransform& transform) {
  for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
    const glm::dvec3 moved = transform.apply({positions[i], positions[i + 1], positions[i + 2]});
    for (int axis = 0; axis < 3; ++axis) positions[i + idx(axis)] = moved[axis];
  }
  return positions;
}

TEST(GroundTransform, TurnsAboutTheUpAxis) {
  const GroundTransform about_y{.up = Axis::Y, .angle_deg = 90.0};
  EXPECT_LT(glm::distance(about_y.apply({0, 5, 1}), glm::dvec3(1, 5, 0)), 1e-12);
  const GroundTransform about_z{.up = Axis::Z, .angle_deg = 90.0, .pivot = {1, 1, 0}, .shift = {0, 0, 2}};
  EXPECT_LT(glm::distance(about_z.apply({2, 1, 7}), glm::dvec3(1, 2, 9)), 1e-12);
}

TEST(GroundTransform, AlignmentFindsWhatWasDone) {
  Random random(41);
  for (const Axis up : {Axis::X, Axis::Y, Axis::Z}) {
    std::vector<double> points(60);
    for (double& value : points) value = random.between(-50, 50);
    GroundTransform done{.up = up, .angle_deg = 123.0, .pivot = {3, 4, 5}, .shift = {7, -8, 9}};
    done.shift[static_cast<int>(up)] = 0.0;
    const std::vector<double> to = transformed(points, done);
    EXPECT_LT(largest_difference(transformed(points, find_alignment(up, points, to)), to), 1e-9);
  }
}

TEST(Turn, MovesAllPointsAlikeInAnyOrderOfChannels) {
  Random random(42);
  for (const Clip& clip : {make_figure(30), make_wild_figure(random, 30), make_clip(2, 10)}) {
    for (const double angle_deg : {90.0, -33.0, 400.0}) {
      GroundTransform expected{.up = Axis::Y, .angle_deg = angle_deg};
      expected.pivot = root_position(clip.skeleton, clip.settings.position_rule, clip.motion, 0, 0);
      const Clip turned = after(clip, "turn", {{"angle", angle_deg}});
      EXPECT_LT(largest_difference(positions_of(turned), transformed(positions_of(clip), expected)), 1e-9);
    }
  }
}

TEST(Turn, ThereAndBackIsTheStart) {
  const Clip clip = make_clip(2, 20);
  const Clip back = after(after(clip, "turn", {{"angle", 70.0}}), "turn", {{"angle", -70.0}});
  for (ChannelIndex channel = 0; channel < 6; ++channel) {
    EXPECT_THAT(samples_of(back, channel), testing::Pointwise(DoubleNear(1e-9), samples_of(clip, channel)));
  }
}

TEST(Turn, KnowsOtherUpAxesAndAddedOffsets) {
  Clip clip = make_figure(10);
  clip.skeleton.set_offset(0, {11, 12, 13});
  clip.settings.position_rule = PositionRule::Add;
  clip.settings.up_axis = Axis::Z;
  GroundTransform expected{.up = Axis::Z, .angle_deg = 50.0};
  const Clip turned = after(clip, "turn", {{"angle", 50.0}, {"pivot", choice_of("turn", "pivot", "origin")}});
  EXPECT_LT(largest_difference(positions_of(turned), transformed(positions_of(clip), expected)), 1e-9);
}

TEST(Turn, OfARootWithoutTheChannelsIsRefused) {
  SkeletonBuilder builder;
  builder.open_joint("Hips");
  builder.add_channel(ChannelKind::Xposition);
  builder.add_channel(ChannelKind::Xrotation);
  builder.close_joint();
  Clip clip;
  clip.skeleton = builder.build().value();
  clip.motion = Motion(2, 3, 0.1);
  const auto message_of = [&](std::string_view id, Given given) {
    const Operation& operation = *find_operation(id);
    const auto outcome = make_operation_edit(clip, operation, whole_clip(clip), values_of(operation, {given}));
    return outcome ? std::string() : outcome.error().message;
  };
  EXPECT_EQ(message_of("turn", {"angle", 10.0}), "'Hips' has no Zposition channel to move it by.");
  EXPECT_EQ(message_of("move", {"y", 10.0}), "'Hips' has no Yposition channel to move it by.");
  EXPECT_EQ(message_of("move", {"x", 10.0}), "");
}

TEST(Move, ShiftsAllPoints) {
  const Clip clip = make_figure(10);
  const Clip moved = after(clip, "move", {{"x", 1.0}, {"y", -2.0}, {"z", 3.0}});
  const GroundTransform expected{.shift = {1, -2, 3}};
  EXPECT_LT(largest_difference(positions_of(moved), transformed(positions_of(clip), expected)), 1e-12);
}

TEST(ZeroStart, StandsOverTheOriginAndLooksAhead) {
  const Clip clip = make_figure(20);
  const Clip zeroed = after(clip, "zero-start");
  EXPECT_NEAR(zeroed.motion.sample(0, 0), 0.0, 1e-12);
  EXPECT_NEAR(zeroed.motion.sample(2, 0), 0.0, 1e-12);
  EXPECT_EQ(zeroed.motion.sample(1, 0), clip.motion.sample(1, 0));
  EXPECT_NEAR(twist_deg(zeroed.skeleton, zeroed.motion, 0, 0, Axis::Y), 0.0, 1e-9);
  const Clip again = after(zeroed, "zero-start");
  EXPECT_LT(largest_difference(positions_of(again), positions_of(zeroed)), 1e-9);
  const Clip lowered = after(clip, "zero-start", {{"height", 1.0}, {"heading", 0.0}});
  EXPECT_EQ(lowered.motion.sample(1, 0), 0.0);
  EXPECT_EQ(lowered.motion.sample(3, 5), clip.motion.sample(3, 5));
}

TEST(InPlace, TakesTheWayOut) {
  const Clip clip = make_figure(40);
  const Clip still = after(clip, "in-place");
  EXPECT_THAT(samples_of(still, 0), Each(clip.motion.sample(0, 0)));
  EXPECT_THAT(samples_of(still, 2), Each(clip.motion.sample(2, 0)));
  EXPECT_EQ(samples_of(still, 1), samples_of(clip, 1));
  const Clip swaying = after(clip, "in-place", {{"keep", choice_of("in-place", "keep", "sway")}});
  EXPECT_NEAR(swaying.motion.sample(2, 39), clip.motion.sample(2, 0), 1e-9);
  EXPECT_NEAR(swaying.motion.sample(0, 39), swaying.motion.sample(0, 0), 1e-9);
  EXPECT_GT(std::abs(swaying.motion.sample(0, 20) - swaying.motion.sample(0, 0)), 0.5);
}

TEST(PathScale, MakesTheWayLonger) {
  const Clip clip = make_figure(40);
  const Clip longer = after(clip, "path-scale", {{"factor", 3.0}});
  EXPECT_NEAR(longer.motion.sample(2, 39) - longer.motion.sample(2, 0), 3.0 * (clip.motion.sample(2, 39) - clip.motion.sample(2, 0)), 1e-9);
  EXPECT_EQ(samples_of(longer, 1), samples_of(clip, 1));
  EXPECT_TRUE(outcome_of(clip, "path-scale", whole_clip(clip), {{"factor", 1.0}}).edit.empty());
}

}  // namespace
}  // namespace marey::test
