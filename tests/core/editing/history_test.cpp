#include "core/editing/history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>

#include "core/editing/clip_operations.h"
#include "core/editing/curve_operations.h"
#include "tests/core/editing/generated_clips.h"

namespace marey::test {
namespace {

using testing::Each;
using testing::ElementsAre;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Edit setting(const std::string& name, FrameIndex first, std::vector<double> values) {
  Edit edit;
  edit.name = name;
  edit.samples.push_back({kCurve, first, std::move(values)});
  return edit;
}

class HistoryTest : public testing::Test {
 protected:
  Status apply(const std::string& name, double value, FrameIndex frame = 0) {
    return history.apply(clip, setting(name, frame, {value}));
  }
  Status drag(GestureId gesture, double delta) {
    return history.apply_gesture(clip, gesture, [&](const Clip& before) {
      return make_move_edit(before, selected(kCurve, {1, 2}), delta, {});
    });
  }
  [[nodiscard]] std::vector<double> curve() const { return samples_of(clip, kCurve); }

  Clip clip = make_clip_with_curve({0, 10, 20, 30});
  History history;
};

TEST_F(HistoryTest, UndoAndRedoGoByName) {
  EXPECT_EQ(history.undo_name(), "");
  EXPECT_EQ(history.redo_name(), "");
  ASSERT_TRUE(apply("first", 1));
  ASSERT_TRUE(apply("second", 2));
  EXPECT_EQ(history.undo_name(), "second");
  EXPECT_TRUE(history.undo(clip));
  EXPECT_EQ(history.undo_name(), "first");
  EXPECT_EQ(history.redo_name(), "second");
  EXPECT_THAT(curve(), ElementsAre(1, 10, 20, 30));
  EXPECT_TRUE(history.redo(clip));
  EXPECT_THAT(curve(), ElementsAre(2, 10, 20, 30));
  EXPECT_FALSE(history.redo(clip));
}

TEST_F(HistoryTest, NothingToUndoOrRedoChangesNothing) {
  const std::vector<std::uint64_t> before = bits_of(clip);
  EXPECT_FALSE(history.undo(clip));
  EXPECT_FALSE(history.redo(clip));
  EXPECT_EQ(bits_of(clip), before);
  EXPECT_EQ(history.revision(), 0u);
}

TEST_F(HistoryTest, AnEditForgetsWhatCouldBeRedone) {
  ASSERT_TRUE(apply("first", 1));
  history.undo(clip);
  ASSERT_TRUE(apply("other", 2));
  EXPECT_EQ(history.redo_depth(), 0);
  EXPECT_EQ(history.undo_depth(), 1);
}

TEST_F(HistoryTest, AnEditThatChangesNothingIsNoStepAndForgetsNothing) {
  ASSERT_TRUE(apply("first", 1));
  history.undo(clip);
  const std::uint64_t revision = history.revision();
  ASSERT_TRUE(apply("same value", 0));
  ASSERT_TRUE(history.apply(clip, Edit{}));
  EXPECT_EQ(history.undo_depth(), 0);
  EXPECT_EQ(history.redo_depth(), 1);
  EXPECT_EQ(history.revision(), revision);
}

TEST_F(HistoryTest, ARefusedEditChangesNothing) {
  ASSERT_TRUE(apply("first", 1));
  history.undo(clip);
  const std::vector<std::uint64_t> before = bits_of(clip);
  const std::uint64_t revision = history.revision();
  EXPECT_FALSE(apply("no number", kNan));
  EXPECT_FALSE(apply("no frame", 1, 4));
  EXPECT_EQ(bits_of(clip), before);
  EXPECT_EQ(history.redo_depth(), 1);
  EXPECT_EQ(history.revision(), revision);
}

TEST_F(HistoryTest, ADragIsOneStepThatAlwaysSeesTheClipBeforeIt) {
  for (const double delta : {1.0, 5.0, -3.0, 2.0}) ASSERT_TRUE(drag(7, delta));
  EXPECT_THAT(curve(), ElementsAre(0, 12, 22, 30));
  EXPECT_EQ(history.undo_depth(), 1);
  EXPECT_EQ(history.undo_name(), "Move 2 samples of Hips Zrotation");
  history.undo(clip);
  EXPECT_THAT(curve(), ElementsAre(0, 10, 20, 30));
  history.redo(clip);
  EXPECT_THAT(curve(), ElementsAre(0, 12, 22, 30));
}

TEST_F(HistoryTest, TwoDragsAreTwoSteps) {
  ASSERT_TRUE(drag(1, 1));
  ASSERT_TRUE(drag(2, 1));
  EXPECT_EQ(history.undo_depth(), 2);
  EXPECT_THAT(curve(), ElementsAre(0, 12, 22, 30));
}

TEST_F(HistoryTest, GestureZeroIsNoGesture) {
  ASSERT_TRUE(drag(0, 1));
  ASSERT_TRUE(drag(0, 1));
  EXPECT_EQ(history.undo_depth(), 2);
  history.cancel_gesture(clip, 0);
  EXPECT_EQ(history.undo_depth(), 2);
}

TEST_F(HistoryTest, ADragBackToTheStartIsAsIfItHadNotBeen) {
  ASSERT_TRUE(apply("first", 1));
  history.undo(clip);
  for (const double delta : {0.0, 4.0, 0.0}) {
    ASSERT_TRUE(drag(7, delta));
    EXPECT_EQ(history.redo_depth(), delta == 0.0 ? 1 : 0);
  }
  EXPECT_EQ(history.undo_depth(), 0);
  history.redo(clip);
  EXPECT_THAT(curve(), ElementsAre(1, 10, 20, 30));
}

TEST_F(HistoryTest, ADragGoesOnAfterItsStepVanished) {
  for (const double delta : {4.0, 0.0, 6.0, 2.0}) ASSERT_TRUE(drag(7, delta));
  EXPECT_THAT(curve(), ElementsAre(0, 12, 22, 30));
  EXPECT_EQ(history.undo_depth(), 1);
}

TEST_F(HistoryTest, CancelTakesADragBackWithEverythingItForgot) {
  ASSERT_TRUE(apply("first", 1));
  ASSERT_TRUE(apply("second", 2));
  history.undo(clip);
  ASSERT_TRUE(drag(7, 4));
  ASSERT_TRUE(drag(7, 5));
  history.cancel_gesture(clip, 8);
  EXPECT_EQ(history.undo_depth(), 2);
  history.cancel_gesture(clip, 7);
  EXPECT_THAT(curve(), ElementsAre(1, 10, 20, 30));
  EXPECT_EQ(history.undo_name(), "first");
  EXPECT_EQ(history.redo_name(), "second");
  history.cancel_gesture(clip, 7);
  EXPECT_EQ(history.undo_name(), "first");
}

TEST_F(HistoryTest, ARefusedStateLeavesTheDragWhereItWas) {
  ASSERT_TRUE(drag(7, 4));
  EXPECT_FALSE(drag(7, kNan));
  EXPECT_THAT(curve(), ElementsAre(0, 14, 24, 30));
  ASSERT_TRUE(drag(7, 1));
  EXPECT_THAT(curve(), ElementsAre(0, 11, 21, 30));
  EXPECT_EQ(history.undo_depth(), 1);
}

TEST_F(HistoryTest, AGestureIsOverOnceItWasUndone) {
  ASSERT_TRUE(drag(7, 4));
  ASSERT_TRUE(apply("later", 1));
  history.undo(clip);
  history.undo(clip);
  history.redo(clip);
  history.cancel_gesture(clip, 7);
  EXPECT_THAT(curve(), ElementsAre(0, 14, 24, 30));
  ASSERT_TRUE(drag(7, 1));
  EXPECT_THAT(curve(), ElementsAre(0, 15, 25, 30));
  EXPECT_EQ(history.undo_depth(), 2);
}

TEST_F(HistoryTest, AGestureIsOverEvenIfItsStepIsRedoneAtOnce) {
  ASSERT_TRUE(drag(7, 4));
  history.undo(clip);
  history.redo(clip);
  ASSERT_TRUE(drag(7, 1));
  EXPECT_EQ(history.undo_depth(), 2);
}

TEST_F(HistoryTest, AGestureIsOverOnceAnotherStepWasApplied) {
  ASSERT_TRUE(drag(7, 4));
  ASSERT_TRUE(apply("later", 1));
  history.undo(clip);
  history.cancel_gesture(clip, 7);
  EXPECT_EQ(history.undo_depth(), 1);
  EXPECT_EQ(history.redo_depth(), 1);
}

TEST_F(HistoryTest, SavedIsAPlaceInTime) {
  EXPECT_TRUE(history.is_saved());
  ASSERT_TRUE(apply("first", 1));
  EXPECT_FALSE(history.is_saved());
  history.mark_saved();
  ASSERT_TRUE(apply("second", 2));
  history.undo(clip);
  EXPECT_TRUE(history.is_saved());
  history.undo(clip);
  EXPECT_FALSE(history.is_saved());
  history.redo(clip);
  EXPECT_TRUE(history.is_saved());
}

TEST_F(HistoryTest, ASavedStateOnAForgottenBranchNeverComesBack) {
  ASSERT_TRUE(apply("first", 1));
  history.mark_saved();
  history.undo(clip);
  ASSERT_TRUE(apply("other", 1));
  EXPECT_FALSE(history.is_saved());
  history.undo(clip);
  EXPECT_FALSE(history.is_saved());
}

TEST_F(HistoryTest, SavingInTheMiddleOfADragSavesThatState) {
  ASSERT_TRUE(drag(7, 4));
  history.mark_saved();
  ASSERT_TRUE(drag(7, 5));
  EXPECT_FALSE(history.is_saved());
  history.undo(clip);
  EXPECT_FALSE(history.is_saved());
}

TEST_F(HistoryTest, MemoryIsBoundedAndTheOldestStepsGoFirst) {
  const std::size_t step_bytes = edit_bytes(setting("s", 0, {1}));
  history = History(3 * step_bytes);
  for (int value = 1; value <= 5; ++value) {
    ASSERT_TRUE(apply("s", value));
    EXPECT_LE(history.bytes(), 3 * step_bytes);
  }
  EXPECT_EQ(history.undo_depth(), 3);
  while (history.undo(clip)) EXPECT_EQ(history.bytes(), 3 * step_bytes);
  EXPECT_THAT(curve(), ElementsAre(2, 10, 20, 30));
  EXPECT_FALSE(history.is_saved());
}

TEST_F(HistoryTest, WhatADragCouldGiveBackCountsAsMemory) {
  const std::size_t step_bytes = edit_bytes(setting("s", 0, {1}));
  const std::size_t drag_bytes = step_bytes + sizeof(double) + sizeof("Move 2 samples of Hips Zrotation") - sizeof("s");
  history = History(step_bytes + drag_bytes);
  ASSERT_TRUE(apply("s", 1));
  history.undo(clip);
  ASSERT_TRUE(drag(7, 4));
  EXPECT_EQ(history.bytes(), step_bytes + drag_bytes);
  history.undo(clip);
  EXPECT_EQ(history.bytes(), drag_bytes);
  ASSERT_TRUE(apply("s", 1));
  ASSERT_TRUE(apply("s", 2));
  history.undo(clip);
  history.undo(clip);
  ASSERT_TRUE(drag(8, 4));
  EXPECT_EQ(history.bytes(), drag_bytes);
  history.cancel_gesture(clip, 8);
  EXPECT_EQ(history.bytes(), 0u);
}

TEST_F(HistoryTest, TheSavedStateIsKnownAlsoAsTheOldest) {
  const std::size_t step_bytes = edit_bytes(setting("s", 0, {1}));
  history = History(2 * step_bytes);
  ASSERT_TRUE(apply("s", 1));
  history.mark_saved();
  ASSERT_TRUE(apply("s", 2));
  ASSERT_TRUE(apply("s", 3));
  while (history.undo(clip)) continue;
  EXPECT_THAT(curve(), ElementsAre(1, 10, 20, 30));
  EXPECT_TRUE(history.is_saved());
}

TEST_F(HistoryTest, TheNewestStepStaysHoweverLargeItIs) {
  history = History(1);
  ASSERT_TRUE(apply("first", 1));
  ASSERT_TRUE(apply("second", 2));
  EXPECT_EQ(history.undo_depth(), 1);
  EXPECT_TRUE(history.undo(clip));
  EXPECT_THAT(curve(), ElementsAre(1, 10, 20, 30));
}

TEST_F(HistoryTest, RevisionGrowsByOnePerChangeWithTheFramesOfIt) {
  ASSERT_TRUE(apply("s", 1, 3));
  EXPECT_EQ(history.revision(), 1u);
  EXPECT_EQ(history.last_changed_frames(), (FrameRange{3, 1}));
  ASSERT_TRUE(drag(7, 1));
  EXPECT_EQ(history.revision(), 2u);
  EXPECT_EQ(history.last_changed_frames(), (FrameRange{1, 2}));
  history.undo(clip);
  history.undo(clip);
  EXPECT_EQ(history.revision(), 4u);
  EXPECT_EQ(history.last_changed_frames(), (FrameRange{3, 1}));
}

TEST_F(HistoryTest, KnowsTheFramesOfSeveralChanges) {
  EXPECT_EQ(history.changed_frames_since(0).count, 0);
  ASSERT_TRUE(apply("a", 1, 0));
  ASSERT_TRUE(apply("b", 2, 2));
  EXPECT_EQ(history.changed_frames_since(0), (FrameRange{0, 3}));
  EXPECT_EQ(history.changed_frames_since(1), (FrameRange{2, 1}));
  EXPECT_EQ(history.changed_frames_since(2).count, 0);
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(apply("c", 10.0 + i, 1));
  EXPECT_EQ(history.changed_frames_since(history.revision() - 3), (FrameRange{1, 1}));
  EXPECT_TRUE(history.changed_frames_since(0).contains(1'000'000)) << "too long ago to be known";
  EXPECT_TRUE(history.changed_frames_since(history.revision() + 1).contains(1'000'000)) << "of another clip";
}

TEST_F(HistoryTest, AStateOfADragChangesTheFramesOfTheFormerStateToo) {
  const auto lift = [&](FrameRange frames) {
    return history.apply_gesture(
        clip, 7, [=](const Clip& before) { return make_move_edit(before, selected(kCurve, frames), 1, {}); });
  };
  ASSERT_TRUE(lift({0, 1}));
  ASSERT_TRUE(lift({3, 1}));
  EXPECT_EQ(history.last_changed_frames(), (FrameRange{0, 4}));
  ASSERT_TRUE(lift({0, 0}));
  EXPECT_EQ(history.last_changed_frames(), (FrameRange{3, 1}));
  EXPECT_EQ(history.revision(), 3u);
}

TEST(History, FramesThatWereLeftOutAreCountedUntilTheirStepIsForgotten) {
  Clip clip = make_clip(2, 50);
  History history;
  ASSERT_TRUE(history.apply(clip, make_remove_frames_edit({0, 20})));
  EXPECT_GE(history.bytes(), idx(20 * clip.motion.channel_count()) * sizeof(double));
  ASSERT_TRUE(history.undo(clip));
  ASSERT_TRUE(history.apply(clip, make_frame_time_edit(0.5)));
  EXPECT_LT(history.bytes(), 1000u);
}

}  // namespace
}  // namespace marey::test
