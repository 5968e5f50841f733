#include "core/document/document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "core/bvh/reader.h"
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

// The same bytes are a German name and a Russian one; the finding that quotes them follows the choice.
TEST_F(DocumentTest, ReadsNamesInAnotherSetAndBack) {
  const std::string text =
      "HIERARCHY\nROOT H\xFC" "fte\n{\nOFFSET 0 0 0\nCHANNELS 1 Zrotation\nJOINT H\xFC" "fte\n{\nOFFSET 0 1 0\n"
      "CHANNELS 1 Zrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n1 2\n";
  Result<BvhClip> read = read_bvh(text);
  ASSERT_TRUE(read);
  Document opened(std::move(*read), "names.bvh");
  const auto quoted = [&] { return opened.diagnostics().find(DiagnosticCode::DuplicateName)->found; };
  EXPECT_EQ(opened.settings().names_in, CharacterSet::Windows1252);
  EXPECT_EQ(opened.skeleton().name(0), "Hüfte");
  EXPECT_EQ(quoted(), "Hüfte");
  ClipSettings settings = opened.settings();
  settings.names_in = CharacterSet::Windows1251;
  ASSERT_TRUE(opened.apply(make_settings_edit(opened.clip(), settings)));
  EXPECT_EQ(opened.history().undo_name(), "Read names as Windows-1251");
  EXPECT_EQ(opened.skeleton().name(0), "Hьfte");
  EXPECT_EQ(quoted(), "Hьfte");
  EXPECT_EQ(opened.save_text(), text);
  EXPECT_TRUE(opened.find_changes().empty());
  ASSERT_TRUE(opened.undo());
  EXPECT_EQ(opened.skeleton().name(0), "Hüfte");
  EXPECT_EQ(quoted(), "Hüfte");
  ASSERT_TRUE(opened.redo());
  EXPECT_EQ(opened.skeleton().name(1), "Hьfte");
}

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

// Lines of a real file's shape; what was not edited comes out byte by byte, odd spacing and decimals included.
constexpr std::string_view kBvhLines[] = {"HIERARCHY\n",
                                          "ROOT Hips\n",
                                          "{\n",
                                          "\tOFFSET 0.00 0.00 0.00\n",
                                          "\tCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n",
                                          "\tEnd Site\n",
                                          "\t{\n",
                                          "\t\tOFFSET 0.00 90.00 0.00\n",
                                          "\t}\n",
                                          "}\n",
                                          "MOTION\n",
                                          "Frames: 3\n",
                                          "Frame Time: .0083333\n",
                                          "8.03\t35.01\t88.36\t-3.41\t14.78\t-164.35\n",
                                          "7.81\t35.10\t86.47\t-3.78\t12.94\t-166.97\n",
                                          "7.60\t35.22\t84.50\t-4.11\t10.99\t-169.41\n"};

std::string bvh_text(FrameIndex changed_frame = -99, std::string_view changed_row = {}) {
  std::string text;
  for (int line = 0; line < 16; ++line) text += line == 13 + changed_frame ? changed_row : kBvhLines[line];
  return text;
}

TEST(DocumentSave, GivesTheFileBackButForWhatWasEdited) {
  Document document(read_bvh(bvh_text()).value(), "walk.bvh");
  EXPECT_EQ(document.save_text(), bvh_text());
  ASSERT_TRUE(document.apply(make_sample_edit(document.clip(), kCurve, 1, 45.5)));
  EXPECT_EQ(document.save_text(), bvh_text(1, "7.81\t35.10\t86.47\t45.50\t12.94\t-166.97\n"));
  document.undo();
  EXPECT_EQ(document.save_text(), bvh_text());
}

TEST(DocumentChanges, AreWhatADownloadWouldDifferIn) {
  Document document(read_bvh(bvh_text()).value(), "walk.bvh");
  EXPECT_TRUE(document.find_changes().empty());
  ASSERT_TRUE(document.apply(make_sample_edit(document.clip(), kCurve, 1, 45.5)));
  EXPECT_EQ(describe(document.find_changes()), "1 sample in 1 channel, frame 2");
  ASSERT_TRUE(document.apply(make_sample_edit(document.clip(), 0, 2, 1.0)));
  ASSERT_TRUE(document.apply(make_offset_edit(document.clip(), 0, {1.0, 2.0, 3.5})));
  ASSERT_TRUE(document.apply(make_frame_time_edit(0.02)));
  EXPECT_EQ(describe(document.find_changes()), "2 samples in 2 channels, frames 2 to 3; 1 offset; the frame time");
  while (document.undo()) continue;
  EXPECT_EQ(describe(document.find_changes()), "nothing");
  while (document.redo()) continue;
  document.mark_saved();
  EXPECT_TRUE(document.find_changes().empty());
}

TEST(DocumentChanges, CountFramesThatWereLeftOut) {
  Document document(read_bvh(bvh_text()).value(), "walk.bvh");
  ASSERT_TRUE(document.apply(make_remove_frames_edit({0, 1})));
  EXPECT_EQ(describe(document.find_changes()), "1 frame left out");
  ASSERT_TRUE(document.apply(make_sample_edit(document.clip(), kCurve, 0, 45.5)));
  EXPECT_EQ(describe(document.find_changes()), "1 sample in 1 channel, frame 1; 1 frame left out");
  document.mark_saved();
  EXPECT_TRUE(document.find_changes().empty());
  document.undo();
  document.undo();
  EXPECT_EQ(describe(document.find_changes()), "1 sample in 1 channel, frame 2; 1 frame added");
  while (document.redo()) continue;
  EXPECT_TRUE(document.find_changes().empty());
}

TEST(DocumentSave, KeepsTheBytesOfFramesThatMoveUp) {
  Document document(read_bvh(bvh_text()).value(), "walk.bvh");
  ASSERT_TRUE(document.apply(make_remove_frames_edit({0, 1})));
  std::string expected;
  for (int line = 0; line < 16; ++line) {
    if (line != 13) expected += kBvhLines[line];
  }
  expected.replace(expected.find("Frames: 3"), 9, "Frames: 2");
  EXPECT_EQ(document.save_text(), expected);
  document.undo();
  EXPECT_EQ(document.save_text(), bvh_text());
}

TEST(DocumentSave, KeepsTheBitsOfEveryEditedSample) {
  Document document(read_bvh(bvh_text()).value(), "walk.bvh");
  const SampleSelection all = selected(kCurve, {0, 3});
  ASSERT_TRUE(document.apply(make_scale_edit(document.clip(), all, 1.0 / 3.0, 0.1)));
  const Result<BvhClip> again = read_bvh(document.save_text());
  ASSERT_TRUE(again);
  for (ChannelIndex channel = 0; channel < 6; ++channel) {
    for (FrameIndex frame = 0; frame < 3; ++frame) {
      EXPECT_EQ(again->motion.sample(channel, frame), document.motion().sample(channel, frame));
    }
  }
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
