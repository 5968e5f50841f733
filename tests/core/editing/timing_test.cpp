#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/editing/history.h"
#include "core/editing/warp_curve.h"
#include "core/motion/resampling.h"
#include "tests/core/editing/operation_clips.h"

namespace marey::test {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

OperationTarget frames_target(const Clip& clip, FrameRange frames) {
  OperationTarget target = whole_clip(clip);
  target.frames = frames;
  return target;
}

TEST(Retime, ThereAndBackIsTheStartToTheBit) {
  Random random(51);
  for (const int frame_count : {2, 3, 10, 41}) {
    const Clip clip = make_wild_figure(random, frame_count);
    const Clip slow = after(clip, "retime", {{"speed", 0.5}});
    EXPECT_EQ(slow.motion.frame_count(), 2 * frame_count - 1);
    EXPECT_EQ(bits_of(after(slow, "retime", {{"speed", 2.0}})), bits_of(clip));
  }
}

TEST(Retime, ChangesTheRangeAlone) {
  const Clip clip = make_figure(30);
  const Clip fast = after(clip, "retime", frames_target(clip, {10, 11}), {{"speed", 2.0}});
  ASSERT_EQ(fast.motion.frame_count(), 25);
  for (int frame = 0; frame < 25; ++frame) {
    const int source = frame < 10 ? frame : frame <= 15 ? 10 + 2 * (frame - 10) : frame + 5;
    EXPECT_EQ(fast.motion.sample(7, frame), clip.motion.sample(7, source)) << frame;
    EXPECT_EQ(fast.file_frames[idx(frame)], source);
  }
}

TEST(Retime, MarksNewFrames) {
  const Clip clip = make_figure(3);
  EXPECT_THAT(after(clip, "retime", {{"speed", 0.5}}).file_frames, ElementsAre(0, kNewFrame, 1, kNewFrame, 2));
}

TEST(Retime, KeepsTheCountOfTurns) {
  const Clip clip = make_clip_with_curve({0, 100, 200, 300, 400, 500});
  const Clip slow = after(clip, "retime", {{"speed", 0.25}});
  EXPECT_EQ(slow.motion.sample(kCurve, 20), 500.0);
  EXPECT_NEAR(slow.motion.sample(kCurve, 18), 450.0, 1e-9);
}

TEST(SetDuration, GivesTheRangeADuration) {
  const Clip clip = make_figure(31);
  const Clip longer = after(clip, "set-duration", {{"seconds", 2.0}});
  EXPECT_NEAR(longer.motion.duration_s(), 2.0, 1e-9);
  EXPECT_EQ(longer.motion.sample(7, 0), clip.motion.sample(7, 0));
  EXPECT_EQ(longer.motion.sample(7, 60), clip.motion.sample(7, 30));
}

TEST(Warp, GoesThroughItsPointsAndNeverBackwards) {
  const auto times = make_warped_times({{0, 0}, {10, 40}, {30, 50}}, 31, 1e6);
  ASSERT_TRUE(times);
  ASSERT_EQ(times->size(), 51u);
  EXPECT_EQ(times->front(), 0.0);
  EXPECT_NEAR((*times)[40], 10.0, 1e-12);
  EXPECT_EQ(times->back(), 30.0);
  for (std::size_t i = 1; i < times->size(); ++i) EXPECT_GT((*times)[i], (*times)[i - 1]);
}

TEST(Warp, WithoutPointsOrWithTheirOwnPlacesIsTheStart) {
  const Clip clip = make_figure(20);
  const Operation& warp = *find_operation("warp");
  for (const char* text : {"", "1:1", "5:5,9:9", "1:1,20:20"}) {
    OperationValues values = initial_values(warp);
    values.texts[0] = text;
    const auto outcome = make_operation_edit(clip, warp, whole_clip(clip), values);
    ASSERT_TRUE(outcome) << text;
    EXPECT_EQ(bits_of(edited(clip, outcome->edit)), bits_of(clip)) << text;
  }
}

TEST(Warp, RefusesPointsThatDoNotRise) {
  EXPECT_EQ(parse_warp_points("1:1,50").error().message, "\"50\" is not FRAME:FRAME, counted from 1, such as 50:80.");
  EXPECT_EQ(parse_warp_points("9:9,5:20").error().message, "\"5:20\" does not lie behind the point before it.");
  EXPECT_FALSE(parse_warp_points("0:1"));
  EXPECT_FALSE(make_warped_times({{0, 0}, {9, 1e9}}, 10, 1e6));
}

TEST(Resample, IsWhatMotionHasAndKeepsTheDuration) {
  const Clip clip = make_figure(31);
  const Clip resampled_clip = after(clip, "resample", {{"rate", 60.0}});
  EXPECT_EQ(resampled_clip.motion.frame_count(), 61);
  EXPECT_DOUBLE_EQ(resampled_clip.motion.frame_time_s(), 1.0 / 60.0);
  const Motion expected = resampled(clip.skeleton, clip.motion, 60.0).value();
  EXPECT_THAT(resampled_clip.motion.samples(), testing::ElementsAreArray(expected.samples()));
  EXPECT_TRUE(outcome_of(clip, "resample", whole_clip(clip), {{"rate", 30.0}}).edit.empty());
}

TEST(Trim, AndCutKeepSamplesAndFileFrames) {
  const Clip clip = make_figure(10);
  const Clip middle = after(clip, "trim", frames_target(clip, {3, 4}));
  EXPECT_THAT(middle.file_frames, ElementsAre(3, 4, 5, 6));
  EXPECT_EQ(middle.motion.sample(5, 0), clip.motion.sample(5, 3));
  EXPECT_THAT(after(clip, "trim", frames_target(clip, {0, 2})).file_frames, ElementsAre(0, 1));
  EXPECT_THAT(after(clip, "trim", frames_target(clip, {8, 2})).file_frames, ElementsAre(8, 9));
  EXPECT_THAT(after(clip, "cut", frames_target(clip, {1, 7})).file_frames, ElementsAre(0, 8, 9));
  const Operation& cut = *find_operation("cut");
  EXPECT_FALSE(make_operation_edit(clip, cut, whole_clip(clip), {}));
}

TEST(Insert, HoldsOrBlends) {
  const Clip clip = make_clip_with_curve({0, 10, 40});
  EXPECT_THAT(samples_of(after(clip, "insert", {{"at", 2.0}, {"count", 2.0}}), kCurve), ElementsAre(0, 10, 10, 10, 40));
  const Clip blended = after(clip, "insert", {{"at", 2.0}, {"count", 2.0}, {"fill", 1.0}});
  EXPECT_THAT(samples_of(blended, kCurve), testing::Pointwise(DoubleNear(1e-9), {0.0, 10.0, 20.0, 30.0, 40.0}));
  EXPECT_THAT(blended.file_frames, ElementsAre(0, 1, kNewFrame, kNewFrame, 2));
  EXPECT_THAT(samples_of(after(clip, "insert", {{"at", 99.0}, {"count", 1.0}}), kCurve), ElementsAre(0, 10, 40, 40));
}

Clip appended(const Clip& clip, const Clip& other, std::initializer_list<Given> given) {
  return edited(clip, outcome_of(clip, "append", whole_clip(clip), given, &other).edit);
}

TEST(Append, WithoutBlendPutsOneBehindTheOther) {
  const Clip clip = make_figure(10);
  const Clip both = appended(clip, clip, {{"blend", 0.0}, {"align", 0.0}});
  ASSERT_EQ(both.motion.frame_count(), 20);
  for (int frame = 0; frame < 20; ++frame) EXPECT_EQ(both.motion.sample(9, frame), clip.motion.sample(9, frame % 10));
}

// A clip whose end is appended to itself, wherever it has been moved to, goes on as it was.
TEST(Append, AlignedGoesOnWhereTheClipEnds) {
  const Clip whole = make_figure(40);
  const Clip first = after(whole, "trim", frames_target(whole, {0, 20}));
  Clip second = after(whole, "trim", frames_target(whole, {10, 30}));
  second = after(after(second, "turn", {{"angle", 140.0}}), "move", {{"x", 500.0}, {"z", -70.0}});
  for (const double blend : {10.0}) {
    const Clip both = appended(first, second, {{"blend", blend}});
    ASSERT_EQ(both.motion.frame_count(), 40);
    EXPECT_LT(largest_difference(positions_of(both), positions_of(whole)), 1e-6);
  }
}

TEST(Append, FindsJointsByNameAndSaysWhatIsMissing) {
  const Clip clip = make_figure(10);
  const Clip hips = make_clip(1, 5);
  const OperationOutcome outcome = outcome_of(clip, "append", whole_clip(clip), {{"blend", 0.0}, {"align", 0.0}}, &hips);
  ASSERT_EQ(outcome.notes.size(), 1u);
  EXPECT_EQ(outcome.notes[0], "The other clip does not have 10 joints: Spine and others.");
  const Clip both = edited(clip, outcome.edit);
  EXPECT_EQ(both.motion.sample(7, 12), clip.motion.sample(7, 9));
  Clip renamed = make_clip(1, 5);
  const Operation& append = *find_operation("append");
  EXPECT_TRUE(make_operation_edit(renamed, append, whole_clip(renamed), values_of(append, {}, &clip)));
}

TEST(Splice, TakesJointsFromAnotherClip) {
  const Clip clip = make_figure(20);
  Random random(52);
  const Clip other = make_wild_figure(random, 30);
  OperationTarget target = target_of(clip, {6, 7, 8}, {5, 10});
  const Clip spliced = edited(clip, outcome_of(clip, "splice", target, {{"at", 3.0}}, &other).edit);
  for (int frame = 0; frame < 20; ++frame) {
    const bool inside = frame >= 5 && frame < 15;
    EXPECT_EQ(spliced.motion.sample(7, frame), inside ? other.motion.sample(7, frame - 2) : clip.motion.sample(7, frame));
    EXPECT_EQ(spliced.motion.sample(9, frame), clip.motion.sample(9, frame));
  }
}

}  // namespace
}  // namespace marey::test
