#include "core/editing/curve_operations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/editing/clip_operations.h"
#include "tests/core/editing/generated_clips.h"

namespace marey::test {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::SizeIs;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<double> curve_after(const std::vector<double>& before, const Edit& edit) {
  return samples_of(edited(make_clip_with_curve(before), edit), kCurve);
}

TEST(FalloffWeight, FallsFromOneToZeroAndNeverRises) {
  for (const double radius : {1.0, 1.5, 7.0, 1000.0}) {
    EXPECT_EQ(falloff_weight({radius}, 0.0), 1.0);
    EXPECT_NEAR(falloff_weight({radius}, radius / 2), 0.5, 1e-15);
    EXPECT_EQ(falloff_weight({radius}, radius), 0.0);
    EXPECT_EQ(falloff_weight({radius}, 2 * radius), 0.0);
    for (int i = 1; i <= 100; ++i) {
      EXPECT_LT(falloff_weight({radius}, radius * i / 100), falloff_weight({radius}, radius * (i - 1) / 100));
    }
  }
}

TEST(FalloffWeight, WithoutARadiusOnlyTheSelectionCounts) {
  for (const double radius : {0.0, -3.0, kNan, kInfinity}) {
    EXPECT_EQ(falloff_weight({radius}, 0.0), 1.0);
    EXPECT_EQ(falloff_weight({radius}, 1.0), 0.0);
  }
}

TEST(MoveEdit, MovesEachSampleByTheWeightOfItsNearestSelectedOne) {
  Random random(6);
  for (int round = 0; round < 500; ++round) {
    const int count = random.below(60);
    const Clip clip = make_clip_with_curve(std::vector<double>(idx(count), 0.0));
    SampleSelection selection;
    for (int i = random.below(4); i > 0; --i) selection.add(kCurve, {random.below(60) - 5, 1 + random.below(4)});
    const Falloff falloff{random.between(0, 12)};
    const std::vector<double> after = samples_of(edited(clip, make_move_edit(clip, selection, 1.0, falloff)), kCurve);
    for (FrameIndex frame = 0; frame < count; ++frame) {
      double weight = 0.0;
      for (FrameIndex other = 0; other < count; ++other) {
        if (selection.contains(kCurve, other))
          weight = std::max(weight, falloff_weight(falloff, std::abs(frame - other)));
      }
      ASSERT_EQ(after[idx(frame)], weight) << frame;
    }
  }
}

TEST(MoveEdit, StoresOnlyWhatItTouches) {
  const Clip clip = make_clip(1, 100);
  SampleSelection selection = selected(kCurve, {10, 1});
  selection.add(kCurve, {14, 2});
  selection.add(kCurve, {50, 1});
  selection.add(kCurve + 1, {99, 1});
  const Edit edit = make_move_edit(clip, selection, 1.0, {3.0});
  ASSERT_THAT(edit.samples, SizeIs(3));
  EXPECT_EQ(edit.samples[0].first, 8);
  EXPECT_THAT(edit.samples[0].values, SizeIs(10));
  EXPECT_EQ(edit.samples[1].first, 48);
  EXPECT_THAT(edit.samples[1].values, SizeIs(5));
  EXPECT_EQ(edit.samples[2].first, 97);
  EXPECT_THAT(edit.samples[2].values, SizeIs(3));
}

TEST(MoveEdit, FollowsTheRaisedCosine) {
  const std::vector<double> flat(9, 0.0);
  const Clip clip = make_clip_with_curve(flat);
  // Weights of a raised cosine of radius 4 at 1, 2, 3: (1 + cos 45 deg) / 2, 1 / 2, (1 - cos 45 deg) / 2.
  const std::vector<double> after = curve_after(flat, make_move_edit(clip, selected(kCurve, {4, 1}), 10, {4.0}));
  const double near = 8.535533905932738;
  const double far = 1.4644660940672622;
  EXPECT_THAT(after, ElementsAre(0, DoubleNear(far, 1e-14), DoubleNear(5, 1e-14), DoubleNear(near, 1e-14), 10,
                                 DoubleNear(near, 1e-14), DoubleNear(5, 1e-14), DoubleNear(far, 1e-14), 0));
}

TEST(MoveEdit, SamplesThatAreNotFiniteStayAndLetTheFalloffPass) {
  const std::vector<double> before = {kNan, 0, kInfinity, 0};
  const Clip clip = make_clip_with_curve(before);
  const std::vector<double> after = curve_after(before, make_move_edit(clip, selected(kCurve, {0, 2}), 2, {100.0}));
  EXPECT_TRUE(std::isnan(after[0]));
  EXPECT_EQ(after[1], 2.0);
  EXPECT_EQ(after[2], kInfinity);
  EXPECT_NEAR(after[3], 2.0, 0.01);
  EXPECT_TRUE(reduced_to_changes(clip, make_move_edit(clip, selected(kCurve, {2, 1}), -kInfinity, {})).empty());
}

TEST(ValueEdit, GivesAllSelectedSamplesOneValue) {
  const std::vector<double> before = {1, 2, kNan, 4};
  const Clip clip = make_clip_with_curve(before);
  EXPECT_THAT(curve_after(before, make_value_edit(clip, selected(kCurve, {1, 2}), 7.5)), ElementsAre(1, 7.5, 7.5, 4));
}

TEST(ScaleEdit, ScalesAboutThePivot) {
  const std::vector<double> before = {1, 2, 3, 4};
  const Clip clip = make_clip_with_curve(before);
  const SampleSelection selection = selected(kCurve, {0, 3});
  EXPECT_EQ(compute_selection_mean(clip, selection), 2.0);
  EXPECT_THAT(curve_after(before, make_scale_edit(clip, selection, 3, 2)), ElementsAre(-1, 2, 5, 4));
  EXPECT_THAT(curve_after(before, make_scale_edit(clip, selection, 0, 0.1)), ElementsAre(0.1, 0.1, 0.1, 4));
}

TEST(ScaleEdit, ByOneChangesNoBit) {
  Random random(7);
  for (int round = 0; round < 500; ++round) {
    const Clip clip = make_random_clip(random);
    const Edit edit = make_scale_edit(clip, make_random_selection(random, clip), 1.0, random.between(-1e6, 1e6));
    EXPECT_TRUE(reduced_to_changes(clip, edit).empty());
  }
}

TEST(SmoothEdit, ReplacesTheSelectedRunsOnly) {
  const std::vector<double> before = {0, 0, 9, 0, 0, 0};
  const Clip clip = make_clip_with_curve(before);
  const std::vector<double> after = curve_after(before, make_smooth_edit(clip, selected(kCurve, {2, 1}), 0.5));
  // 9 / (1 + 2 e^-2 + 2 e^-8)
  EXPECT_THAT(after, ElementsAre(0, 0, DoubleNear(7.079136533, 1e-9), 0, 0, 0));
}

TEST(SmoothEdit, WithoutAWidthIsEmpty) {
  const Clip clip = make_clip_with_curve({0, 9, 0});
  for (const double sigma : {0.0, -1.0, kNan, kInfinity}) {
    EXPECT_TRUE(make_smooth_edit(clip, selected(kCurve, {0, 3}), sigma).empty());
  }
}

TEST(CurveOperations, NumbersThatAreNotFiniteAreRefusedOnApplying) {
  const Clip clip = make_clip_with_curve({1, 2, 3});
  const SampleSelection selection = selected(kCurve, {0, 3});
  for (const double number : {kNan, kInfinity}) {
    EXPECT_FALSE(check_edit(clip, make_move_edit(clip, selection, number, {})));
    EXPECT_FALSE(check_edit(clip, make_value_edit(clip, selection, number)));
    EXPECT_FALSE(check_edit(clip, make_scale_edit(clip, selection, number, 0)));
    EXPECT_FALSE(check_edit(clip, make_scale_edit(clip, selection, 2, number)));
    EXPECT_FALSE(check_edit(clip, make_sample_edit(clip, kCurve, 0, number)));
  }
  EXPECT_FALSE(check_edit(clip, make_scale_edit(clip, selection, 1e308, -1e308)));
  EXPECT_FALSE(check_edit(clip, make_sample_edit(clip, 99, 0, 1)));
  EXPECT_FALSE(check_edit(clip, make_offset_edit(clip, 99, glm::dvec3(1))));
}

TEST(CurveOperations, SelectionsOutsideOfTheClipDoNotCount) {
  for (const int frame_count : {0, 1, 2}) {
    const Clip clip = make_clip(1, frame_count);
    SampleSelection selection = selected(-1, {0, 5});
    selection.add(kCurve, {-5, 3});
    selection.add(kCurve, {frame_count, 1000});
    selection.add(99, {0, 5});
    EXPECT_TRUE(make_move_edit(clip, selection, 1, {5.0}).empty());
    EXPECT_TRUE(make_value_edit(clip, selection, 1).empty());
    EXPECT_TRUE(make_scale_edit(clip, selection, 2, 1).empty());
    EXPECT_TRUE(make_smooth_edit(clip, selection, 2).empty());
    EXPECT_EQ(compute_selection_mean(clip, selection), 0.0);
  }
}

TEST(CurveOperations, NeverTouchUnselectedChannels) {
  Random random(8);
  for (int round = 0; round < 1000; ++round) {
    const Clip clip = make_random_clip(random);
    const SampleSelection selection = make_random_selection(random, clip);
    for (const Edit& edit :
         {make_move_edit(clip, selection, 1, {random.between(0, 9)}), make_value_edit(clip, selection, 1),
          make_scale_edit(clip, selection, 0.5, 3), make_smooth_edit(clip, selection, random.between(0.1, 5))}) {
      EXPECT_TRUE(check_edit(clip, edit).ok());
      const std::vector<ChannelIndex> channels = selection.channels();
      for (const SamplesChange& change : edit.samples) {
        EXPECT_TRUE(std::binary_search(channels.begin(), channels.end(), change.channel));
      }
    }
  }
}

TEST(CurveOperations, AreNamedAfterWhatTheyDo) {
  const Clip clip = make_clip(2, 20);
  const ChannelIndex elbow = clip.skeleton.first_channel(1);
  SampleSelection selection = selected(elbow, {0, 1});
  EXPECT_EQ(make_move_edit(clip, selection, 1, {}).name, "Move 1 sample of Joint1 Zrotation");
  selection.add(elbow, {5, 11});
  EXPECT_EQ(make_move_edit(clip, selection, 1, {}).name, "Move 12 samples of Joint1 Zrotation");
  EXPECT_EQ(make_smooth_edit(clip, selection, 1).name, "Smooth Joint1 Zrotation");
  selection.add(elbow + 1, {5, 1});
  selection.add(0, {5, 100});
  EXPECT_EQ(make_move_edit(clip, selection, 1, {}).name, "Move 28 samples in 3 channels");
  EXPECT_EQ(make_value_edit(clip, selection, 1).name, "Set 28 samples in 3 channels");
  EXPECT_EQ(make_scale_edit(clip, selection, 2, 0).name, "Scale 28 samples in 3 channels");
  EXPECT_EQ(make_smooth_edit(clip, selection, 1).name, "Smooth 3 channels");
  EXPECT_EQ(make_sample_edit(clip, elbow, 4, 1).name, "Set Joint1 Zrotation at frame 5");
}

TEST(CurveOperations, KeepTheMeanOfFiniteSamples) {
  const Clip clip = make_clip_with_curve({1, kNan, 3, kInfinity, 8});
  EXPECT_EQ(compute_selection_mean(clip, selected(kCurve, {0, 5})), 4.0);
  EXPECT_EQ(compute_selection_mean(clip, selected(kCurve, {1, 1})), 0.0);
  EXPECT_EQ(compute_selection_mean(clip, {}), 0.0);
}

}  // namespace
}  // namespace marey::test
