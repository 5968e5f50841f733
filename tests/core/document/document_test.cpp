#include "core/document/document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>

#include "core/editing/clip_operations.h"
#include "core/editing/curve_operations.h"
#include "core/skeleton/skeleton_builder.h"
#include "tests/core/editing/generated_clips.h"

namespace marey::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

BvhClip make_bvh_clip(const Clip& clip) {
  BvhClip result;
  result.skeleton = clip.skeleton;
  result.motion = clip.motion;
  return result;
}

class DocumentTest : public testing::Test {
 protected:
  Status set(double value, FrameIndex frame = 0) {
    return document.apply(make_sample_edit(document.clip(), kCurve, frame, value));
  }
  Status drag(GestureId gesture, double delta) {
    return document.apply_gesture(gesture, [&](const Clip& before) {
      return make_move_edit(before, selected(kCurve, {1, 1}), delta, {});
    });
  }
  [[nodiscard]] std::vector<double> ghost(ChannelIndex channel = kCurve) const {
    const std::span<const double> samples = document.saved_samples(channel);
    return {samples.begin(), samples.end()};
  }
  [[nodiscard]] std::vector<double> curve() const { return samples_of(document.clip(), kCurve); }

  Document document{make_bvh_clip(make_clip_with_curve({1, 2, 3})), "walk.bvh"};
};

TEST_F(DocumentTest, OpensWhatWasRead) {
  BvhClip read = make_bvh_clip(make_clip(2, 3));
  read.position_rule = PositionRule::Add;
  read.diagnostics.add({DiagnosticCode::Comment, Severity::Note, {3, 1}, "A comment.", "", "", 1});
  const Document opened(std::move(read), "jump.bvh");
  EXPECT_EQ(opened.file_name(), "jump.bvh");
  EXPECT_EQ(opened.skeleton().joint_count(), 2);
  EXPECT_EQ(opened.motion().frame_count(), 3);
  EXPECT_EQ(opened.settings().position_rule, PositionRule::Add);
  EXPECT_TRUE(opened.diagnostics().contains(DiagnosticCode::Comment));
  EXPECT_FALSE(opened.is_dirty());
}

TEST_F(DocumentTest, IsDirtyUntilSavedOrUndone) {
  ASSERT_TRUE(set(9));
  EXPECT_TRUE(document.is_dirty());
  document.undo();
  EXPECT_FALSE(document.is_dirty());
  document.redo();
  EXPECT_TRUE(document.is_dirty());
  document.mark_saved();
  EXPECT_FALSE(document.is_dirty());
  document.undo();
  EXPECT_TRUE(document.is_dirty());
}

TEST_F(DocumentTest, TheGhostIsTheCurveAsOpened) {
  EXPECT_THAT(ghost(), IsEmpty());
  ASSERT_TRUE(set(9, 0));
  ASSERT_TRUE(set(8, 2));
  EXPECT_THAT(ghost(), ElementsAre(1, 2, 3));
  EXPECT_THAT(ghost(kCurve + 1), IsEmpty());
  document.undo();
  document.undo();
  EXPECT_THAT(ghost(), ElementsAre(1, 2, 3));
}

TEST_F(DocumentTest, TheGhostIsTheCurveAsSaved) {
  ASSERT_TRUE(set(9, 0));
  document.mark_saved();
  EXPECT_THAT(ghost(), IsEmpty());
  ASSERT_TRUE(set(8, 2));
  EXPECT_THAT(ghost(), ElementsAre(9, 2, 3));
}

TEST_F(DocumentTest, UndoBehindASaveLeavesTheSavedCurveAsGhost) {
  ASSERT_TRUE(set(9, 0));
  document.mark_saved();
  document.undo();
  EXPECT_THAT(curve(), ElementsAre(1, 2, 3));
  EXPECT_THAT(ghost(), ElementsAre(9, 2, 3));
  document.mark_saved();
  document.redo();
  EXPECT_THAT(ghost(), ElementsAre(1, 2, 3));
}

TEST_F(DocumentTest, ASaveInTheMiddleOfADragIsTheGhostOfItsEnd) {
  ASSERT_TRUE(drag(5, 10));
  EXPECT_THAT(ghost(), ElementsAre(1, 2, 3));
  document.mark_saved();
  ASSERT_TRUE(drag(5, 20));
  EXPECT_THAT(curve(), ElementsAre(1, 22, 3));
  EXPECT_THAT(ghost(), ElementsAre(1, 12, 3));
  document.mark_saved();
  document.cancel_gesture(5);
  EXPECT_THAT(curve(), ElementsAre(1, 2, 3));
  EXPECT_THAT(ghost(), ElementsAre(1, 22, 3));
}

TEST_F(DocumentTest, ARefusedOrEmptyEditLeavesNoGhost) {
  EXPECT_FALSE(set(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(set(1, 99));
  EXPECT_FALSE(document.apply(make_sample_edit(document.clip(), 99, 0, 1)));
  ASSERT_TRUE(set(1, 0));
  EXPECT_FALSE(drag(5, std::numeric_limits<double>::infinity()));
  ASSERT_TRUE(drag(5, 0));
  EXPECT_THAT(ghost(), IsEmpty());
  EXPECT_FALSE(document.is_dirty());
  EXPECT_EQ(document.revision(), 0u);
}

TEST(GuessMetresPerUnit, MakesTheFigureHuman) {
  const auto guess_for_stature = [](double stature) {
    SkeletonBuilder builder;
    builder.open_joint("Hips");
    builder.add_end_site({0, stature, 0});
    builder.close_joint();
    return guess_metres_per_unit(builder.build().value());
  };
  constexpr double kCmu = 0.0254 / 0.45;
  EXPECT_EQ(guess_for_stature(1.75), 1.0);
  EXPECT_EQ(guess_for_stature(170), 0.01);
  EXPECT_EQ(guess_for_stature(1800), 0.001);
  EXPECT_EQ(guess_for_stature(68), 0.0254);
  EXPECT_EQ(guess_for_stature(30), kCmu);
  // The links of 10, 12 and 16 units of the paper's gymnast.
  EXPECT_EQ(guess_for_stature(38), kCmu);
  EXPECT_EQ(guess_for_stature(0), 0.01);
}

}  // namespace
}  // namespace marey::test
