// Nasty relatives of the rows of ../shared/bvh-in-the-wild.md: other places, other line ends, several at once. Each is
// read as a person would read it, with a finding, or its finding says what was lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/core/bvh/bvh_texts.h"

namespace marey {
namespace {

using namespace test;
using Code = DiagnosticCode;

const Rows kOneRow = {{1, 2, 3, 4, 5, 6, 7, 8, 9}};

std::string sound_file() { return file_with_lines(kChild, 9); }

/// What the trees are made of but for the bytes of the names, which blanks beyond ASCII may follow.
void expect_same_tree(const Skeleton& skeleton, const Skeleton& expected) {
  ASSERT_EQ(skeleton.node_count(), expected.node_count());
  for (NodeIndex i = 0; i < expected.node_count(); ++i) {
    Node node = skeleton.node(i);
    node.name_bytes = expected.node(i).name_bytes;
    EXPECT_EQ(node, expected.node(i));
  }
  EXPECT_TRUE(std::equal(skeleton.channels().begin(), skeleton.channels().end(), expected.channels().begin(),
                         expected.channels().end()));
}

/// Expects the figure and the values of sound_file(), a finding, and a written file that says the same without one.
void expect_read_with(Code code, const std::string& text) {
  for (const std::string& variant : {text, replaced(text, "\n", "\r\n"), replaced(text, "\n", "\r"), replaced(text, "\n", "\n\n")}) {
    const BvhClip clip = read_or_fail(variant);
    SCOPED_TRACE(variant + listing(clip));
    expect_same_tree(clip.skeleton, read_or_fail(sound_file()).skeleton);
    EXPECT_EQ(rows_of(clip), kOneRow) << variant << listing(clip);
    EXPECT_EQ(clip.motion.frame_time_s(), 0.04) << variant;
    EXPECT_TRUE(clip.diagnostics.contains(code)) << diagnostic_id(code) << "\n" << variant << listing(clip);
    const BvhClip again = read_or_fail(written(clip));
    EXPECT_TRUE(same_numbers(clip.skeleton, clip.motion, again.skeleton, again.motion)) << variant << "---\n" << written(clip);
    EXPECT_EQ(written(again), written(clip));
  }
}

void expect_changed(Code code, std::string_view what, const std::vector<std::string>& by) {
  for (const std::string& text : by) {
    SCOPED_TRACE(text);
    ASSERT_NE(sound_file().find(what), std::string::npos) << what;
    expect_read_with(code, replaced(sound_file(), what, text));
  }
}

TEST(WildVariants, KeywordsGluedToMarksAndNumbers) {
  expect_changed(Code::UnexpectedToken, "OFFSET 0 5 0", {"OFFSET: 0 5 0", "OFFSET=0 5 0", "OFFSET0 5 0", "offset: 0 5 0"});
  expect_changed(Code::UnexpectedToken, "CHANNELS 3 ", {"CHANNELS: 3 ", "CHANNELS3 ", "CHANNELS 3: ", "CHANNELS 3, ", "CHANNELS 3"});
  expect_changed(Code::UnexpectedToken, "MOTION\n", {"MOTION:\n", "MOTION;\n", "Motion :\n", "MOTON\n"});
  expect_changed(Code::UnexpectedToken, "HIERARCHY\n", {"HIERARCHY:\n", "HIERACHY\n", "HEIRARCHY\n", "Hierarchy;\n"});
  expect_changed(Code::UnexpectedToken, "JOINT Chest", {"JOINT: Chest", "JOINTS Chest", "Jiont Chest"});
  expect_changed(Code::UnexpectedToken, "OFFSET 0 6 0", {"OFSET 0 6 0", "OFFFSET 0 6 0", "Ofsfet 0 6 0"});
  expect_changed(Code::UnexpectedToken, "CHANNELS 3", {"CHANELS 3", "CHANNEL 3"});
  expect_changed(Code::UnexpectedToken, "ROOT Hips", {"ROOOT Hips", "ROT Hips", "ROOT: Hips"});
}

TEST(WildVariants, EndSitesInOneWordOrTwoLines) {
  expect_changed(Code::UnexpectedToken, "End Site", {"End_Site", "End-Site", "END_SITE", "End"});
  expect_changed(Code::KeywordCase, "End Site", {"end site", "END SITE", "endsite", "ENDSITE", "end\n site"});
  const std::string apart = replaced(sound_file(), "End Site", "End\n    Site");
  EXPECT_EQ(written(read_or_fail(apart)), apart);
  expect_no_warnings(read_or_fail(apart));
}

TEST(WildVariants, ChannelNamesWithMarksAroundThem) {
  expect_changed(Code::UnexpectedToken, "3 Zrotation Xrotation Yrotation",
                 {"3 Zrotation, Xrotation, Yrotation", "3, Zrotation, Xrotation, Yrotation,", "3 \"Zrotation\" 'Xrotation' Yrotation",
                  "3 Zrotation; Xrotation; Yrotation", "3Zrotation Xrotation Yrotation"});
}

TEST(WildVariants, FrameLinesInOtherWords) {
  expect_changed(Code::UnexpectedToken, "Frame Time:", {"Frame_Time:", "Frame-Time:", "FRAME TIME =", "FrameTime ="});
  expect_changed(Code::FrameTimeLooksLikeRate, "Frame Time: 0.04",
                 {"Frame Rate: 25", "FrameRate: 25", "framerate = 25", "FPS: 25", "Frame_Rate:25", "Frame Time: 25"});
  expect_changed(Code::UnexpectedToken, "Frames: 1", {"Frame: 1", "Frame Count: 1", "Frames = 1", "Frames 1", "FRAMES; 1"});
  for (const std::string spelling : {"FrameTime: 0.04", "Frame Time :0.04", "Frame  Time\t:\t0.04", "Frame Time:\n0.04"}) {
    const std::string text = replaced(sound_file(), "Frame Time: 0.04", spelling);
    EXPECT_EQ(written(read_or_fail(text)), text);
    EXPECT_EQ(read_or_fail(text).motion.frame_time_s(), 0.04);
    expect_no_warnings(read_or_fail(text));
  }
}

TEST(WildVariants, AFrameTimeThatIsMissingTakesNoSample) {
  const BvhClip clip = read_or_fail(replaced(sound_file(), "Frame Time: 0.04", "Frame Time:"));
  EXPECT_EQ(rows_of(clip), kOneRow);
  expect_finding(clip, Code::MissingFrameTime);
  const BvhClip count = read_or_fail(replaced(sound_file(), "Frames: 1", "Frames:"));
  EXPECT_EQ(rows_of(count), kOneRow);
  EXPECT_EQ(count.motion.frame_time_s(), 0.04);
  expect_finding(count, Code::MissingFrameCount);
}

TEST(WildVariants, BlanksBeyondAscii) {
  for (const std::string blank : {"\u00a0", "\u3000", "\u2003", "\u200b", "\ufeff", "\u2009", "\xa0"}) {
    SCOPED_TRACE(blank);
    expect_changed(Code::WideBlank, "OFFSET 0 5 0", {"OFFSET" + blank + "0 5 0", "OFFSET 0" + blank + "5" + blank + "0", blank + "OFFSET 0 5 0"});
    expect_changed(Code::WideBlank, "JOINT Chest", {"JOINT" + blank + "Chest", "JOINT Chest" + blank});
    expect_changed(Code::WideBlank, "End Site", {"End" + blank + "Site"});
    expect_changed(Code::WideBlank, "CHANNELS 3 Zrotation Xrotation", {"CHANNELS" + blank + "3" + blank + "Zrotation" + blank + "Xrotation"});
    expect_changed(Code::WideBlank, "Frames: 1", {"Frames:" + blank + "1", "Frames" + blank + ": 1" + blank});
    expect_changed(Code::WideBlank, "Frame Time: 0.04", {"Frame" + blank + "Time:" + blank + "0.04"});
    expect_changed(Code::WideBlank, "1 2 3 4 5 6 7 8 9", {"1" + blank + "2 3 4 5 6 7 8 9", blank + "1 2 3 4 5 6 7 8 9" + blank});
    expect_changed(Code::WideBlank, "HIERARCHY", {blank + blank + "HIERARCHY" + blank});
  }
  const std::string name = replaced(sound_file(), "Chest", "Bip01\u00a0Neck");
  EXPECT_EQ(read_or_fail(name).skeleton.name(1), "Bip01\u00a0Neck");
  EXPECT_TRUE(read_or_fail(name).diagnostics.empty());
  const std::string header = replaced(sound_file(), "OFFSET 0 5 0", "OFFSET\u00a00 5 0");
  EXPECT_EQ(written(read_or_fail(header)), header);
}

TEST(WildVariants, ControlBlanksAreBlanks) {
  for (const std::string blank : {"\f", "\v", "\t\t", " \t "}) {
    const std::string text = blank + replaced(replaced(sound_file(), " ", blank), "Site" + blank, "Site ") + blank;
    EXPECT_EQ(rows_of(read_or_fail(text)), kOneRow);
    expect_no_warnings(read_or_fail(text));
    EXPECT_EQ(written(read_or_fail(text)), text);
  }
}

TEST(WildVariants, CommentsOfEveryKindAnywhere) {
  for (const std::string comment : {"# x { } ROOT", "// OFFSET 1 2 3", "; MOTION", "/* ROOT { */", "/* two\n   lines } */"}) {
    SCOPED_TRACE(comment);
    expect_changed(Code::Comment, "ROOT", {comment + "\nROOT"});
    expect_changed(Code::Comment, "    CHANNELS", {"    " + comment + "\n    CHANNELS"});
    expect_changed(Code::Comment, "Yrotation\n", {"Yrotation " + comment + "\n"});
    expect_changed(Code::Comment, "MOTION\n", {comment + "\nMOTION " + comment + "\n" + comment + "\n"});
    expect_changed(Code::Comment, "Frame Time: 0.04\n", {"Frame Time: 0.04\n" + comment + "\n"});
    const std::string text = replaced(sound_file(), "ROOT", comment + "\nROOT");
    EXPECT_EQ(written(read_or_fail(text)), text);
  }
}

TEST(WildVariants, LinesOfTextBetweenTheRows) {
  for (const std::string line : {"; second", "-- second", "Frame 2", "% 2", "/* second */", "Take two starts", "second:"}) {
    const std::string text = one_joint_file("3", "1 2 3\n" + line + "\n4 5 6\n" + line + "\n\n7 8 9\n");
    const BvhClip clip = read_or_fail(text);
    EXPECT_EQ(rows_of(clip), three_rows()) << line << "\n" << listing(clip);
    EXPECT_TRUE(clip.diagnostics.contains(Code::UnexpectedToken) || clip.diagnostics.contains(Code::Comment)) << line;
    EXPECT_EQ(written(clip), text);
  }
  const BvhClip second = read_or_fail(one_joint_file("9", "1 2 3\nMOTION\nFrames: 1\nFrame Time: 1\n4 5 6\n"));
  EXPECT_EQ(second.motion.frame_count(), 1);
  expect_finding(second, Code::TextAfterMotion, {15, 1});
}

TEST(WildVariants, DecimalCommasBetweenSemicolons) {
  for (const std::string gap : {";", "; ", " ; ", ";\t"}) {
    const std::string text = one_joint_file("2", replaced("1,5 2,5 3\n4 5,25 -6,5\n", " ", gap));
    const BvhClip clip = read_or_fail(text);
    EXPECT_EQ(rows_of(clip), (Rows{{1.5, 2.5, 3}, {4, 5.25, -6.5}})) << text << listing(clip);
    expect_finding(clip, Code::DecimalComma, {14, 1});
    EXPECT_EQ(written(clip), text);
  }
}

TEST(WildVariants, WordsInPlaceOfNumbersAreErrorsAndNeverNumbers) {
  for (const std::string word : {"1d5", "0x10", "1_000", "1e", "1e+", "--1", "-", "\"1.5\"", "1/2", "1.5f", "\u22121", "1.2.3", "+-1"}) {
    const BvhClip row = read_or_fail(one_joint_file("2", "1 2 3\n4 " + word + " 6\n"));
    EXPECT_EQ(rows_of(row), (Rows{{1, 2, 3}, {4, 2, 6}})) << word;
    expect_finding(row, Code::BadNumber, {15, 3});
    const BvhClip offset = read_or_fail(replaced(sound_file(), "OFFSET 0 5 0", "OFFSET 0 " + word + " 0"));
    EXPECT_TRUE(offset.diagnostics.contains(Code::BadNumber)) << word << listing(offset);
  }
  for (const std::string word : {"1.#INF", "-nan(ind)", "Infinity", "-1.#QNAN", "NaN", "+inf"}) {
    expect_finding(read_or_fail(one_joint_file("2", "1 2 3\n4 " + word + " 6\n")), Code::NotFinite, {15, 3});
  }
}

TEST(WildVariants, TextAboveTheHierarchyMayBeginWithAKeyword) {
  for (const std::string text : {"Motion of a walk\n", "Root of all: Hips\nJoint work\n", "Frames: made by hand\n", "End of May\n"}) {
    expect_read_with(Code::UnexpectedToken, text + sound_file());
  }
  EXPECT_EQ(refusal_of("MOTION\nFrames: 1\nFrame Time: 1\n1 2 3\n" + std::string(kOneJoint)).code, Code::MissingRoot);
}

TEST(WildVariants, JointsNestedInEndSites) {
  const std::string text = replaced(file_with_lines(kChild, 10), "      OFFSET 0 6 0\n",
                                    "      OFFSET 0 6 0\n      JOINT tip\n      {\n        OFFSET 1 0 0\n        CHANNELS 1 "
                                    "Zrotation\n      }\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.skeleton.name(2), "End Site");
  EXPECT_EQ(clip.skeleton.name(3), "tip");
  EXPECT_EQ(clip.skeleton.parent(3), 2) << "it stands at the end of the end site's bone";
  expect_finding(clip, Code::EndSiteWithChannels, {10, 5});
  EXPECT_EQ(rows_of(clip), (Rows{{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}}));
  expect_round_trip(clip.skeleton, clip.motion, clip.style);
}

TEST(WildVariants, AChainOfFifteenHundredJoints) {
  constexpr int kJoints = 1500;
  std::string text = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 1 Zrotation\n";
  std::string row = "0";
  for (int i = 1; i < kJoints; ++i) {
    text += "JOINT j\n{\nOFFSET 0 1 0\nCHANNELS 1 Zrotation\n";
    row += ' ' + std::to_string(i);
  }
  text += "End Site\n{\nOFFSET 0 1 0\n}\n";
  for (int i = 0; i < kJoints; ++i) text += "}\n";
  text += "MOTION\nFrames: 1\nFrame Time: 0.04\n" + row + "\n";
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.skeleton.joint_count(), kJoints);
  EXPECT_EQ(clip.skeleton.parent(kJoints - 1), kJoints - 2);
  EXPECT_EQ(clip.motion.sample(kJoints - 1, 0), kJoints - 1);
  EXPECT_EQ(written(clip), text);
}

}  // namespace
}  // namespace marey
