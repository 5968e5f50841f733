#include "core/editing/edit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/editing/clip_operations.h"
#include "tests/core/editing/generated_clips.h"

namespace marey::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Edit replacing(ChannelIndex channel, FrameIndex first, std::vector<double> values) {
  Edit edit;
  edit.samples.push_back({channel, first, std::move(values)});
  return edit;
}

DiagnosticCode refusal_of(const Clip& clip, const Edit& edit) {
  const Status status = check_edit(clip, edit);
  EXPECT_FALSE(status.ok());
  return status ? DiagnosticCode::NotBvh : status.error().code;
}

TEST(Edit, SwappedTwiceLeavesEveryBit) {
  Random random(1);
  int checked = 0;
  for (int round = 0; round < 5000; ++round) {
    Clip clip = make_random_clip(random);
    Edit edit = make_random_edit(random, clip);
    if (!check_edit(clip, edit)) continue;
    const std::vector<std::uint64_t> before = bits_of(clip);
    const FrameRange frames = edited_frames(clip, edit);
    swap_edit(clip, edit);
    EXPECT_TRUE(edit.frames || edited_frames(clip, edit) == frames);
    swap_edit(clip, edit);
    ASSERT_EQ(bits_of(clip), before);
    ++checked;
  }
  EXPECT_GT(checked, 2500);
}

TEST(Edit, TakesFramesOutAndBringsThemBack) {
  const Clip clip = make_clip_with_curve({1, 2, 3, 4, 5});
  Clip changed = clip;
  Edit edit = make_remove_frames_edit({1, 2});
  EXPECT_EQ(edit.name, "Remove frames 2 to 3");
  ASSERT_TRUE(check_edit(changed, edit));
  swap_edit(changed, edit);
  EXPECT_THAT(samples_of(changed, kCurve), ElementsAre(1, 4, 5));
  EXPECT_THAT(changed.file_frames, ElementsAre(0, 3, 4));
  Edit second = make_remove_frames_edit({0, 1});
  swap_edit(changed, second);
  EXPECT_THAT(samples_of(changed, kCurve), ElementsAre(4, 5));
  EXPECT_THAT(changed.file_frames, ElementsAre(3, 4));
  swap_edit(changed, second);
  swap_edit(changed, edit);
  EXPECT_EQ(bits_of(changed), bits_of(clip));
}

TEST(Edit, RefusesFramesThatAreNotThereAndAnEmptyClip) {
  const Clip clip = make_clip_with_curve({1, 2, 3});
  for (const FrameRange frames : {FrameRange{0, 3}, FrameRange{-1, 1}, FrameRange{2, 2}, FrameRange{4, 0}, FrameRange{0, -1}}) {
    EXPECT_EQ(refusal_of(clip, make_remove_frames_edit(frames)), DiagnosticCode::InvalidArgument);
  }
  Edit both = make_remove_frames_edit({0, 1});
  both.samples.push_back({kCurve, 0, {1.0}});
  EXPECT_EQ(refusal_of(clip, both), DiagnosticCode::InvalidArgument);
  Edit narrow;
  narrow.frames = FramesChange{{0, 0}, Motion(1, 1, 0.1), {7}};
  EXPECT_EQ(refusal_of(clip, narrow), DiagnosticCode::InvalidArgument);
}

TEST(Edit, ReducedHasTheSameEffectAndNothingElse) {
  Random random(2);
  for (int round = 0; round < 5000; ++round) {
    const Clip clip = make_random_clip(random);
    const Edit edit = make_random_edit(random, clip);
    if (!check_edit(clip, edit)) continue;
    const Edit reduced = reduced_to_changes(clip, edit);
    const Clip after = edited(clip, edit);
    ASSERT_EQ(bits_of(edited(clip, reduced)), bits_of(after));
    EXPECT_EQ(reduced.empty(), bits_of(after) == bits_of(clip));
    EXPECT_LE(edit_bytes(reduced), edit_bytes(edit));
    EXPECT_EQ(reduced.name, edit.name);
  }
}

TEST(Edit, ReducedIsCutToTheFirstAndLastDifference) {
  const Clip clip = make_clip_with_curve({0, 1, 2, 3, 4});
  const Edit reduced = reduced_to_changes(clip, replacing(kCurve, 0, {0, 7, 2, 8, 4}));
  ASSERT_THAT(reduced.samples, SizeIs(1));
  EXPECT_EQ(reduced.samples[0].first, 1);
  EXPECT_THAT(reduced.samples[0].values, ElementsAre(7, 2, 8));
}

TEST(Edit, TheSignOfZeroIsAChange) {
  const Clip clip = make_clip_with_curve({0.0});
  EXPECT_FALSE(reduced_to_changes(clip, replacing(kCurve, 0, {-0.0})).empty());
  EXPECT_TRUE(reduced_to_changes(clip, replacing(kCurve, 0, {0.0})).empty());
}

TEST(Edit, OutsideOfTheClipIsRefused) {
  const Clip clip = make_clip(1, 3);
  const int past_channels = clip.motion.channel_count();
  constexpr int kMax = std::numeric_limits<int>::max();
  for (const Edit& edit :
       {replacing(-1, 0, {1}), replacing(past_channels, 0, {1}), replacing(kMax, 0, {1}), replacing(0, -1, {1}),
        replacing(0, 3, {1}), replacing(0, kMax, {1}), replacing(0, 4, {}), replacing(0, 0, {1, 2, 3, 4})}) {
    EXPECT_EQ(refusal_of(clip, edit), DiagnosticCode::InvalidArgument);
  }
  EXPECT_TRUE(check_edit(clip, replacing(0, 0, {1, 2, 3})).ok());
  EXPECT_TRUE(check_edit(clip, replacing(0, 3, {})).ok());
}

TEST(Edit, OverlapIsRefused) {
  const Clip clip = make_clip(1, 9);
  Edit edit = replacing(0, 4, {1, 2, 3});
  edit.samples.push_back({0, 0, {1, 2, 3, 4}});
  EXPECT_TRUE(check_edit(clip, edit).ok());
  edit.samples.push_back({1, 5, {1}});
  EXPECT_TRUE(check_edit(clip, edit).ok());
  edit.samples.push_back({0, 6, {1}});
  EXPECT_EQ(refusal_of(clip, edit), DiagnosticCode::InvalidArgument);
  edit.samples.clear();
  edit.offsets = {{1, glm::dvec3(1)}, {0, glm::dvec3(2)}, {1, glm::dvec3(3)}};
  EXPECT_EQ(refusal_of(clip, edit), DiagnosticCode::InvalidArgument);
}

TEST(Edit, NoSampleStopsBeingFinite) {
  const Clip clip = make_clip_with_curve({1, kNan, kInfinity});
  EXPECT_EQ(refusal_of(clip, replacing(kCurve, 0, {kNan})), DiagnosticCode::NotFinite);
  EXPECT_EQ(refusal_of(clip, replacing(kCurve, 0, {kInfinity, 0, 0})), DiagnosticCode::NotFinite);
  EXPECT_TRUE(check_edit(clip, replacing(kCurve, 0, {2, kNan, kNan})).ok());
  EXPECT_TRUE(check_edit(clip, replacing(kCurve, 0, {2, 3, 4})).ok());
}

TEST(Edit, RefusesNumbersThatMeanNothing) {
  const Clip clip = make_clip(1, 1);
  for (const double number : {kNan, kInfinity, -kInfinity}) {
    Edit edit;
    edit.offsets = {{0, {0, number, 0}}};
    EXPECT_EQ(refusal_of(clip, edit), DiagnosticCode::NotFinite);
  }
  for (const double number : {0.0, -1.0, kNan, kInfinity}) {
    Edit edit;
    edit.frame_time_s = number;
    EXPECT_EQ(refusal_of(clip, edit), DiagnosticCode::FrameTimeNotPositive);
    edit = {};
    edit.settings = clip.settings;
    edit.settings->metres_per_unit = number;
    EXPECT_EQ(refusal_of(clip, edit), DiagnosticCode::InvalidArgument);
  }
  for (const NodeIndex node : {-1, clip.skeleton.node_count()}) {
    Edit edit;
    edit.offsets = {{node, glm::dvec3(0)}};
    EXPECT_EQ(refusal_of(clip, edit), DiagnosticCode::InvalidArgument);
  }
}

TEST(Edit, RefusesAFrameTimeThatReadersTakeForARate) {
  const Clip clip = make_clip(1, 1);
  Edit edit = make_frame_time_edit(10.0);
  EXPECT_EQ(refusal_of(clip, edit), DiagnosticCode::FrameTimeLooksLikeRate);
  edit = make_frame_time_edit(std::nextafter(10.0, 0.0));
  EXPECT_TRUE(check_edit(clip, edit));
}

TEST(Edit, RefusesFramesThatAreNotFinite) {
  const Clip clip = make_clip(1, 3);
  Edit edit;
  edit.frames = FramesChange{{1, 1}, Motion(clip.motion.channel_count(), 1, 1.0), {1}};
  EXPECT_TRUE(check_edit(clip, edit));
  edit.frames->inserted.channel_samples(2)[0] = kNan;
  EXPECT_EQ(refusal_of(clip, edit), DiagnosticCode::NotFinite);
}

TEST(Edit, FramesAreTheHullOfTheSamples) {
  const Clip clip = make_clip(1, 20);
  Edit edit = replacing(0, 4, {1, 2, 3});
  EXPECT_EQ(edited_frames(clip, edit), (FrameRange{4, 3}));
  edit.samples.push_back({1, 10, {1, 2}});
  EXPECT_EQ(edited_frames(clip, edit), (FrameRange{4, 8}));
  edit.offsets = {{0, glm::dvec3(1)}};
  EXPECT_EQ(edited_frames(clip, edit), (FrameRange{0, 20}));
}

TEST(Edit, OfTheSettingsOnlyThePositionRuleMovesPoses) {
  const Clip clip = make_clip(1, 20);
  Edit edit;
  edit.frame_time_s = 1.0;
  edit.settings = clip.settings;
  edit.settings->up_axis = Axis::Z;
  EXPECT_EQ(edited_frames(clip, edit).count, 0);
  edit.settings->position_rule = PositionRule::Add;
  EXPECT_EQ(edited_frames(clip, edit), (FrameRange{0, 20}));
}

TEST(Edit, HullIgnoresWhatIsEmpty) {
  EXPECT_EQ(hull({3, 0}, {7, 2}), (FrameRange{7, 2}));
  EXPECT_EQ(hull({7, 2}, {3, 0}), (FrameRange{7, 2}));
  EXPECT_EQ(hull({7, 2}, {3, 1}), (FrameRange{3, 6}));
  EXPECT_EQ(hull({0, 9}, {3, 1}), (FrameRange{0, 9}));
}

}  // namespace
}  // namespace marey::test
