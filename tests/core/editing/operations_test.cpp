// What each operation on curves does: known numbers and properties.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/editing/curve_operations.h"
#include "core/signal/butterworth.h"
#include "core/signal/median.h"
#include "core/signal/savitzky_golay.h"
#include "tests/core/editing/operation_clips.h"

namespace marey::test {
namespace {

using testing::DoubleNear;
using testing::Each;
using testing::ElementsAre;
using testing::Pointwise;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

OperationTarget curve_target(const Clip& clip, FrameRange frames, int blend_in = 0, int blend_out = 0) {
  OperationTarget target = target_of(clip, {kCurve}, frames);
  target.blend_in_frames = blend_in;
  target.blend_out_frames = blend_out;
  return target;
}

// The curve of a clip of one joint after an operation on some of its frames; all without a range.
std::vector<double> changed(const std::vector<double>& curve, std::string_view operation, std::initializer_list<Given> given,
                            FrameRange frames = {0, 1 << 20}) {
  const Clip clip = make_clip_with_curve(curve);
  return samples_of(after(clip, operation, curve_target(clip, frames), given), kCurve);
}

std::vector<double> make_random_curve(int count) {
  Random random(3);
  std::vector<double> curve(idx(count));
  for (double& value : curve) value = random.between(-90, 90);
  return curve;
}

TEST(BlendWeights, AreARaisedCosine) {
  OperationTarget target;
  target.frames = {5, 8};
  target.blend_in_frames = 3;
  target.blend_out_frames = 1;
  EXPECT_THAT(blend_weights(target), Pointwise(DoubleNear(1e-12), {0.5 * (1 - std::sqrt(0.5)), 0.5, 0.5 * (1 + std::sqrt(0.5)), 1.0,
                                                                   1.0, 1.0, 1.0, 0.5}));
  target.weight = 0.25;
  EXPECT_DOUBLE_EQ(blend_weights(target)[4], 0.25);
}

TEST(Operations, BlendTheirResultIn) {
  const Clip clip = make_clip_with_curve(std::vector<double>(20, 10.0));
  const Clip result = after(clip, "offset", curve_target(clip, {5, 10}, 3, 2), {{"by", 8.0}});
  const std::vector<double> curve = samples_of(result, kCurve);
  EXPECT_EQ(curve[4], 10.0);
  EXPECT_NEAR(curve[6], 14.0, 1e-12);
  EXPECT_EQ(curve[8], 18.0);
  EXPECT_EQ(curve[12], 18.0);
  EXPECT_EQ(curve[15], 10.0);
  EXPECT_LT(curve[14], curve[13]);
}

TEST(Operations, OfTheTableAndOfGesturesAreTheSame) {
  const std::vector<double> curve = make_random_curve(60);
  const Clip clip = make_clip_with_curve(curve);
  const FrameRange frames{10, 30};
  const Clip by_table = after(clip, "smooth", curve_target(clip, frames), {{"sigma", 3.0}});
  const Clip by_gesture = edited(clip, make_smooth_edit(clip, selected(kCurve, frames), 3.0));
  EXPECT_EQ(samples_of(by_table, kCurve), samples_of(by_gesture, kCurve));
  const Clip scaled = after(clip, "scale", curve_target(clip, frames),
                            {{"factor", 2.5}, {"pivot", choice_of("scale", "pivot", "value")}, {"value", 7.0}});
  EXPECT_EQ(samples_of(scaled, kCurve), samples_of(edited(clip, make_scale_edit(clip, selected(kCurve, frames), 2.5, 7.0)), kCurve));
}

TEST(Operations, FilterTheWholeCurveAndTakeTheRange) {
  const std::vector<double> curve = make_random_curve(80);
  const FrameRange frames{20, 15};
  std::vector<double> whole(curve.size());
  const auto expect_range_of_whole = [&](const std::vector<double>& result) {
    for (int i = 0; i < 80; ++i) EXPECT_EQ(result[idx(i)], frames.contains(i) ? whole[idx(i)] : curve[idx(i)]) << i;
  };
  compute_butterworth(curve, 5.0, 30.0, whole);
  expect_range_of_whole(changed(curve, "butterworth", {{"cutoff", 5.0}}, frames));
  compute_savitzky_golay(curve, {9, 4, 0}, whole);
  expect_range_of_whole(changed(curve, "savitzky-golay", {{"window", 9.0}, {"degree", 4.0}}, frames));
  compute_median(curve, 7, whole);
  expect_range_of_whole(changed(curve, "median", {{"window", 7.0}}, frames));
}

TEST(Butterworth, RefusesCutoffsThatTheRateDoesNotHold) {
  const Clip clip = make_figure(40);
  const Operation& operation = *find_operation("butterworth");
  const auto refused = make_operation_edit(clip, operation, whole_clip(clip), values_of(operation, {{"cutoff", 15.0}}));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "'cutoff' is below half the frame rate, 15 Hz, not 15.");
}

TEST(Butterworth, SuggestsACutoff) {
  Clip clip = make_clip_with_curve(make_random_curve(300));
  const std::span<double> samples = clip.motion.channel_samples(kCurve);
  for (int i = 0; i < 300; ++i) samples[idx(i)] = 0.005 * samples[idx(i)] + 30.0 * std::sin(0.1 * i);
  const OperationOutcome outcome = outcome_of(clip, "butterworth", curve_target(clip, {0, 300}), {{"cutoff", 0.0}});
  ASSERT_EQ(outcome.notes.size(), 2u);
  EXPECT_TRUE(outcome.notes[0].starts_with("The residuals suggest a cut-off of ")) << outcome.notes[0];
  EXPECT_EQ(outcome.edit.samples.size(), 1u);
}

TEST(Despike, TakesSpikesOutAndLeavesTheRest) {
  std::vector<double> curve;
  for (int i = 0; i < 200; ++i) curve.push_back(20.0 * std::sin(0.1 * i));
  const std::vector<double> clean = curve;
  curve[50] += 40.0;
  curve[120] -= 60.0;
  curve[121] -= 55.0;
  const std::vector<double> result = changed(curve, "despike", {});
  for (std::size_t i = 0; i < clean.size(); ++i) EXPECT_NEAR(result[i], clean[i], 0.02) << i;
  EXPECT_EQ(changed(curve, "despike", {}, {60, 30}), curve);
  const Clip clip = make_clip_with_curve(curve);
  EXPECT_THAT(outcome_of(clip, "despike", curve_target(clip, {0, 200})).notes, ElementsAre("2 spikes were taken out."));
}

TEST(FillGaps, FillsWithinTheRangeAndNoLongerOnes) {
  std::vector<double> curve = {0, kNan, 2, 3, kNan, kNan, kNan, 7, kNan};
  const auto filled = changed(curve, "fill-gaps", {});
  EXPECT_THAT(filled, Pointwise(DoubleNear(1e-12), {0, 1, 2, 3, 4, 5, 6, 7, 7}));
  const auto short_ones = changed(curve, "fill-gaps", {{"longest", 2.0}});
  EXPECT_EQ(short_ones[1], 1.0);
  EXPECT_TRUE(std::isnan(short_ones[5]));
  EXPECT_TRUE(std::isnan(changed(curve, "fill-gaps", {}, {2, 4})[1]));
}

TEST(FillGaps, FillsWhatStandsStill) {
  const std::vector<double> curve = {0, 1, 2, 2, 2, 2, 6, 7, 7, 8};
  const auto filled = changed(curve, "fill-gaps", {{"still", 3.0}, {"method", choice_of("fill-gaps", "method", "linear")}});
  EXPECT_THAT(filled, Pointwise(DoubleNear(1e-12), {0, 1, 2, 3, 4, 5, 6, 7, 7, 8}));
  EXPECT_THAT(changed(curve, "fill-gaps", {}), testing::ElementsAreArray(curve));
}

TEST(Scale, KnowsItsPivots) {
  const std::vector<double> curve = {1, 2, 3, 6};
  const auto scaled = [&](std::string_view pivot) {
    return changed(curve, "scale", {{"factor", 2.0}, {"pivot", choice_of("scale", "pivot", pivot)}, {"value", 10.0}});
  };
  EXPECT_THAT(scaled("mean"), ElementsAre(-1, 1, 3, 9));
  EXPECT_THAT(scaled("first"), ElementsAre(1, 3, 5, 11));
  EXPECT_THAT(scaled("last"), ElementsAre(-4, -2, 0, 6));
  EXPECT_THAT(scaled("value"), ElementsAre(-8, -6, -4, 2));
}

TEST(TimeOffset, HoldsOrLoops) {
  const std::vector<double> curve = {0, 1, 2, 3, 4};
  EXPECT_THAT(changed(curve, "time-offset", {{"by", 2.0}}), ElementsAre(0, 0, 0, 1, 2));
  EXPECT_THAT(changed(curve, "time-offset", {{"by", -1.5}}), ElementsAre(1.5, 2.5, 3.5, 4, 4));
  const double loop = choice_of("time-offset", "ends", "loop");
  EXPECT_THAT(changed(curve, "time-offset", {{"by", 2.0}, {"ends", loop}}), ElementsAre(3, 4, 0, 1, 2));
  EXPECT_THAT(changed(curve, "time-offset", {{"by", -7.0}, {"ends", loop}}), ElementsAre(2, 3, 4, 0, 1));
}

TEST(Noise, IsBoundedSeededAndFlowsOverItsPeriod) {
  const std::vector<double> flat(500, 5.0);
  const auto noisy = changed(flat, "noise", {{"amplitude", 3.0}});
  EXPECT_EQ(noisy, changed(flat, "noise", {{"amplitude", 3.0}}));
  EXPECT_NE(noisy, changed(flat, "noise", {{"amplitude", 3.0}, {"seed", 2.0}}));
  EXPECT_THAT(noisy, Each(testing::AllOf(testing::Ge(2.0), testing::Le(8.0))));
  EXPECT_GT(*std::max_element(noisy.begin(), noisy.end()), 7.8);
  EXPECT_LT(*std::min_element(noisy.begin(), noisy.end()), 2.2);
  const auto slow = changed(flat, "noise", {{"amplitude", 3.0}, {"period", 50.0}});
  for (std::size_t i = 1; i < slow.size(); ++i) EXPECT_LT(std::abs(slow[i] - slow[i - 1]), 0.2);
}

TEST(Reverse, TwiceIsTheStart) {
  const std::vector<double> curve = make_random_curve(31);
  const std::vector<double> reversed = changed(curve, "reverse", {});
  EXPECT_EQ(reversed, std::vector<double>(curve.rbegin(), curve.rend()));
  EXPECT_EQ(changed(reversed, "reverse", {}), curve);
}

TEST(Hold, GivesTheRangeOneValue) {
  const std::vector<double> curve = {1, 2, 3, 4, 5};
  EXPECT_THAT(changed(curve, "hold", {}, {1, 3}), ElementsAre(1, 2, 2, 2, 5));
  EXPECT_THAT(changed(curve, "hold", {{"at", choice_of("hold", "at", "last")}}, {1, 3}), ElementsAre(1, 4, 4, 4, 5));
}

TEST(Blends, GoTowardTheNeighbours) {
  const std::vector<double> curve = {10, 0, 0, 0, 20};
  const FrameRange middle{1, 3};
  EXPECT_THAT(changed(curve, "blend-neighbour", {{"factor", -0.5}}, middle), ElementsAre(10, 5, 5, 5, 20));
  EXPECT_THAT(changed(curve, "blend-neighbour", {{"factor", 1.0}}, middle), ElementsAre(10, 20, 20, 20, 20));
  EXPECT_THAT(changed(curve, "breakdown", {{"factor", 0.25}}, middle), ElementsAre(10, 12.5, 12.5, 12.5, 20));
  EXPECT_THAT(changed(curve, "push-pull", {{"factor", 0.0}}, middle), ElementsAre(10, 12.5, 15, 17.5, 20));
  EXPECT_THAT(changed(curve, "push-pull", {{"factor", 2.0}}, middle), ElementsAre(10, -12.5, -15, -17.5, 20));
  EXPECT_THAT(changed(curve, "blend-ease", {{"factor", 1.0}}, middle), ElementsAre(10, 10 + 10.0 / 64, 11.25, 10 + 270.0 / 64, 20));
}

TEST(Blends, ToDefaultIsTheRestPose) {
  Clip clip = make_figure(10);
  clip.settings.position_rule = PositionRule::Replace;
  const Clip rest = after(clip, "blend-default", {{"factor", 1.0}});
  for (ChannelIndex channel = 3; channel < clip.motion.channel_count(); ++channel) {
    EXPECT_THAT(samples_of(rest, channel), Each(0.0));
  }
  EXPECT_EQ(after(clip, "blend-default", {{"factor", 0.5}}).motion.sample(5, 3), 0.5 * clip.motion.sample(5, 3));
}

TEST(MatchSlope, ContinuesTheNeighboursStraight) {
  const std::vector<double> curve = {0, 1, 7, 7, 7, 20, 22};
  EXPECT_THAT(changed(curve, "match-slope", {{"factor", -1.0}}, {2, 3}), ElementsAre(0, 1, 2, 3, 4, 20, 22));
  EXPECT_THAT(changed(curve, "match-slope", {{"factor", 1.0}}, {2, 3}), ElementsAre(0, 1, 14, 16, 18, 20, 22));
  EXPECT_EQ(changed(curve, "match-slope", {{"factor", -1.0}}, {1, 3}), curve);
}

TEST(LoopMatch, EndsWhereItStarts) {
  const std::vector<double> curve = {0, 5, 9, 12, 8};
  for (const std::string_view at : {"end", "start", "both"}) {
    const auto looped = changed(curve, "loop-match", {{"at", choice_of("loop-match", "at", at)}});
    EXPECT_NEAR(looped.front(), looped.back(), 1e-12) << at;
    const auto eased = changed(curve, "loop-match", {{"at", choice_of("loop-match", "at", at)}, {"over", 2.0}});
    EXPECT_NEAR(eased.front(), eased.back(), 1e-12) << at;
    EXPECT_EQ(eased[2], curve[2]);
  }
  EXPECT_THAT(changed(curve, "loop-match", {}), ElementsAre(0, 3, 5, 6, 0));
}

TEST(LoopMatch, TakesWholeTurnsForNoDifference) {
  EXPECT_THAT(changed({10, 100, 190, 280, 370}, "loop-match", {}), ElementsAre(10, 100, 190, 280, 370));
}

}  // namespace
}  // namespace marey::test
