#include "core/document/session.h"

#include <gtest/gtest.h>

#include "core/editing/clip_operations.h"
#include "core/editing/curve_operations.h"
#include "core/editing/figure_draft.h"
#include "tests/core/editing/generated_clips.h"

namespace marey::test {
namespace {

Session open_session(int frame_count) {
  const Clip clip = make_clip(2, frame_count);
  BvhClip read;
  read.skeleton = clip.skeleton;
  read.motion = clip.motion;
  return Session::open(std::move(read), "walk.bvh");
}

TEST(Session, OpensPausedOnTheFirstFrameWithNothingSelected) {
  for (const int frame_count : {0, 1, 20}) {
    const Session session = open_session(frame_count);
    EXPECT_FALSE(session.playback.is_playing());
    EXPECT_EQ(session.playback.position(), 0.0);
    EXPECT_EQ(session.playback.range(), (FrameRange{0, frame_count}));
    EXPECT_TRUE(session.selection.joints().empty());
    EXPECT_EQ(session.document.file_name(), "walk.bvh");
  }
}

TEST(Session, SelectionStartsAnewForAnotherFigure) {
  Session session = open_session(10);
  session.selection.select_only(1);
  const std::uint64_t serial = session.selection.sample_serial();
  const auto change = [&](bool drops_joint) {
    FigureDraft draft = take_apart(session.document.clip());
    draft.nodes[1].name_bytes = "Leg";
    if (drops_joint) draft.nodes.resize(1);
    Edit edit;
    edit.figure = put_together(session.document.clip(), std::move(draft)).value();
    return session.apply(std::move(edit));
  };
  ASSERT_TRUE(change(false));
  EXPECT_EQ(session.selection.active_joint(), 1);
  ASSERT_TRUE(change(true));
  EXPECT_TRUE(session.selection.joints().empty());
  session.selection.select_only(1);
  EXPECT_TRUE(session.selection.joints().empty());
  EXPECT_GT(session.selection.sample_serial(), serial);
  session.undo();
  session.selection.select_only(1);
  EXPECT_EQ(session.selection.active_joint(), 1);
}

TEST(Session, PlaybackAndSelectionFollowTheNumberOfFrames) {
  Session session = open_session(10);
  session.playback.set_position(9);
  session.selection.change_samples().add(3, {8, 2});
  ASSERT_TRUE(session.apply(make_remove_frames_edit({5, 5})));
  EXPECT_EQ(session.playback.position(), 4.0);
  EXPECT_EQ(session.playback.range(), (FrameRange{0, 5}));
  EXPECT_TRUE(session.selection.samples().empty());
  session.undo();
  EXPECT_EQ(session.playback.range(), (FrameRange{0, 10}));
}

TEST(Session, PlaybackFollowsTheFrameTimeThroughUndoAndRedo) {
  Session session = open_session(100);
  const double frame_time_s = session.document.motion().frame_time_s();
  session.playback.set_playing(true);
  const auto frames_in_ten = [&] {
    const double before = session.playback.position();
    session.playback.advance(10 * frame_time_s);
    return session.playback.position() - before;
  };
  EXPECT_EQ(frames_in_ten(), 10.0);
  ASSERT_TRUE(session.apply(make_frame_time_edit(2 * frame_time_s)));
  EXPECT_EQ(frames_in_ten(), 5.0);
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(frames_in_ten(), 10.0);
  EXPECT_TRUE(session.redo());
  EXPECT_EQ(frames_in_ten(), 5.0);
  constexpr GestureId kGesture = 7;
  ASSERT_TRUE(session.apply_gesture(kGesture, [&](const Clip&) { return make_frame_time_edit(frame_time_s / 2); }));
  EXPECT_EQ(frames_in_ten(), 20.0);
  session.cancel_gesture(kGesture);
  EXPECT_EQ(frames_in_ten(), 5.0);
}

TEST(Session, EditingWhilePlayingDoesNotHoldUpPlayback) {
  Session session = open_session(100);
  const double tick_s = session.document.motion().frame_time_s() / 4;
  constexpr GestureId kGesture = 7;
  session.playback.set_playing(true);
  for (int tick = 0; tick < 40; ++tick) {
    ASSERT_TRUE(session.apply_gesture(kGesture, [&](const Clip& clip) {
      return make_move_edit(clip, selected(kCurve, {0, 5}), tick, {2.0});
    }));
    session.playback.advance(tick_s);
  }
  EXPECT_EQ(session.playback.position(), 10.0);
  EXPECT_EQ(session.document.history().undo_depth(), 1);
}

}  // namespace
}  // namespace marey::test
