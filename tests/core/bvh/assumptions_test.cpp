// What the reader assumes or leaves out is said, once and in the right words.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/core/bvh/bvh_texts.h"

namespace marey {
namespace {

using namespace test;
using Code = DiagnosticCode;

std::string with_header(std::string_view motion) { return std::string(kOneJoint) + std::string(motion); }

TEST(FirstRow, KeepsItsColumnsWhenItBeginsWithAWord) {
  const Rows expected = {{0, 2, 3}, {4, 5, 6}};
  const BvhClip clip = read_or_fail(one_joint_file("2", "abc 2 3\n4 5 6\n"));
  EXPECT_EQ(rows_of(clip), expected) << listing(clip);
  expect_finding(clip, Code::BadNumber, {14, 1});
  EXPECT_FALSE(clip.diagnostics.contains(Code::UnexpectedToken));
  EXPECT_EQ(rows_of(read_or_fail(with_header("MOTION\nabc 2 3\n4 5 6\n"))), expected);
}

TEST(FirstRow, IsNotALineOfTextBeforeIt) {
  for (const std::string line : {"Take of monday", "Take number 12 begins", "take 7", "x"}) {
    const BvhClip clip = read_or_fail(one_joint_file("2", line + "\n1 2 3\n4 5 6\n"));
    EXPECT_EQ(rows_of(clip), (Rows{{1, 2, 3}, {4, 5, 6}})) << line;
    EXPECT_TRUE(clip.diagnostics.contains(Code::UnexpectedToken)) << line;
  }
  for (const std::string rows : {"q 1 2 3\n4 5 6\n", "q 1 2 3 4 5 6\n"}) {
    EXPECT_EQ(rows_of(read_or_fail(one_joint_file("2", rows))), (Rows{{1, 2, 3}, {4, 5, 6}})) << rows;
  }
}

TEST(FirstRow, IsNotALineBeforeTheFrameTime) {
  const BvhClip clip = read_or_fail(with_header("MOTION\nFrames: 1\nrate 30 hertz\nFrame Time: 0.5\n1 2 3\n"));
  EXPECT_EQ(clip.motion.frame_time_s(), 0.5);
  EXPECT_EQ(clip.motion.frame_count(), 1);
}

TEST(MotionHeader, ABadFrameCountIsOneFinding) {
  for (const std::string count : {"-5", "2.5", "1e99"}) {
    expect_finding(read_or_fail(one_joint_file(count, "1 2 3\n")), Code::MissingFrameCount, {12, 9});
  }
}

TEST(MotionHeader, ASecondLineIsAFindingAndTheLastOneIsUsed) {
  const BvhClip counts = read_or_fail(with_header("MOTION\nFrames: 9\nFrames: 1\nFrame Time: 0.1\n1 2 3\n"));
  expect_finding(counts, Code::RepeatedFrameCount, {13, 1});
  EXPECT_FALSE(counts.diagnostics.contains(Code::FrameCountMismatch));
  const BvhClip times = read_or_fail(with_header("MOTION\nFrames: 1\nFrame Time: 0.1\nFrame Time: 0.25\n1 2 3\n"));
  expect_finding(times, Code::RepeatedFrameTime, {14, 1});
  EXPECT_EQ(times.motion.frame_time_s(), 0.25);
  expect_no_warnings(read_or_fail(written(times)));
}

TEST(MotionHeader, AFrameTimeIsSavedAsWrittenUntilItIsEdited) {
  for (const std::string time : {"0", "30", "-0.5", "nan", "120.0"}) {
    const std::string text = with_header("MOTION\nFrames: 1\nFrame Time: " + time + "\n1 2 3\n");
    BvhClip clip = read_or_fail(text);
    EXPECT_EQ(written(clip), text);
    clip.motion.set_frame_time_s(0.5);
    EXPECT_EQ(written(clip), with_header("MOTION\nFrames: 1\nFrame Time: 0.5\n1 2 3\n"));
  }
}

TEST(MotionHeader, ARateBelowWhatAFrameTimeCanSayIsLeftOut) {
  const BvhClip clip = read_or_fail(with_header("MOTION\nFrames: 1\nFrame Rate: 0.05\n1 2 3\n"));
  EXPECT_EQ(clip.motion.frame_time_s(), 1.0 / 30.0);
  expect_finding(clip, Code::MissingFrameTime);
  expect_no_warnings(read_or_fail(written(clip)));
}

TEST(Offsets, BeyondDoubleAreOneKindOfFinding) {
  const auto file = [](const std::string& x) { return file_with_lines("  End Site\n  {\n    OFFSET " + x + " 1 2\n  }\n", 6); };
  for (const std::string x : {"1e999", "1e-999", "-1e999"}) {
    const BvhClip clip = read_or_fail(file(x));
    EXPECT_EQ(clip.skeleton.node(1).offset, glm::dvec3(0, 1, 2));
    expect_finding(clip, Code::NumberRange, {8, 12});
    EXPECT_FALSE(clip.diagnostics.contains(Code::NotFinite));
  }
  EXPECT_EQ(written(read_or_fail(file("1e-999"))), file("1e-999"));
  const BvhClip four = read_or_fail(file("1e999 0"));
  EXPECT_TRUE(four.diagnostics.contains(Code::OffsetValueCount));
}

TEST(ScaleChannels, AreKeptAndSaidToMoveNothing) {
  const std::string text =
      file_with_lines("  JOINT b\n  {\n    OFFSET 0 1 0\n    CHANNELS 2 Xscale Yscale\n    End Site\n    {\n      OFFSET 0 1 0\n"
                      "    }\n  }\n", 8);
  const BvhClip clip = read_or_fail(text);
  expect_finding(clip, Code::ScaleChannel, {6, 3});
  EXPECT_EQ(written(clip), text);
  EXPECT_TRUE(read_bvh(text, {.strict = true, .limits = {}}));
}

TEST(SurplusRows, AreSaidToBeTakenForFrames) {
  const BvhClip one = read_or_fail(one_joint_file("2", "1 2 3\n4 5 6\n7 8 9\n"));
  EXPECT_NE(one.diagnostics.find(Code::FrameCountMismatch)->message.find("the last one was taken for a frame"), std::string::npos);
  const BvhClip two = read_or_fail(one_joint_file("1", "1 2 3\n4 5 6\n7 8 9\n"));
  EXPECT_NE(two.diagnostics.find(Code::FrameCountMismatch)->message.find("the last 2 were taken"), std::string::npos);
}

TEST(SurplusRows, AreTextWhenTheyAreOneOfManyLists) {
  const std::string text = one_joint_file("2", "1 2 3\n4 5 6\n2 0 9\n1 0\n4 0 2 5 9\n1 1\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.motion.frame_count(), 2);
  expect_finding(clip, Code::TextAfterMotion, {16, 1});
  EXPECT_FALSE(clip.diagnostics.contains(Code::FrameCountMismatch));
  EXPECT_EQ(written(clip), text);
}

TEST(SurplusRows, WithSurplusValuesLoseNeither) {
  const BvhClip clip = read_or_fail(one_joint_file("2", "1 2 3 4\n4 5 6 7\n7 8 9 8\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}})) << listing(clip);
  expect_finding(clip, Code::SurplusValues, {14, 1}, 3);
  expect_finding(clip, Code::FrameCountMismatch, {12, 9});
  EXPECT_FALSE(clip.diagnostics.contains(Code::TextAfterMotion));
}

TEST(SurplusValues, OfTheLastDeclaredRowAreNotText) {
  const BvhClip clip = read_or_fail(one_joint_file("2", "1 2 3\n4 5 6 7\nnotes\n"));
  expect_finding(clip, Code::RowLength, {15, 7});
  expect_finding(clip, Code::TextAfterMotion, {16, 1});
}

TEST(Utf16, HalvesOfCharactersAreSaid) {
  std::string bytes = "\xff\xfe";
  for (const char c : one_joint_file("1", "1 2 3\n")) bytes += std::string({c, '\0'});
  expect_finding(read_or_fail(bytes + "\x0a"), Code::UnexpectedEnd, {1, 1});
  std::string lone = bytes;
  lone.replace(2 + 2 * one_joint_file("1", "").find("Hips"), 2, std::string("\x00\xd8", 2));
  const BvhClip clip = read_or_fail(lone);
  expect_finding(clip, Code::UnexpectedToken, {1, 1});
  EXPECT_EQ(clip.skeleton.name(0), "\xef\xbf\xbdips");
  EXPECT_FALSE(read_or_fail(bytes).diagnostics.contains(Code::UnexpectedEnd));
}

TEST(Wording, CountsOneThingAsOne) {
  const std::vector<std::string> texts = {
      "HIERARCHY\nROOT a\n{\n  OFFSET 0 0 0\n  CHANNELS 0\n", std::string(kOneJoint) + std::string(1, '\0'),
      file_with_lines("  JOINT b\n  {\n    OFFSET 1\n    CHANNELS 2 Zrotation\n  }\n", 7),
      one_joint_file("1", "1\n1 2 3\n2 3 4\n"), one_joint_file("2", "1 2 3\n"), one_joint_file("1", "1 2 3\n4 5 6\n"),
      "HIERARCHY\nROOT a\n{\nOFFSET 0 9 0\nCHANNELS 1 Yposition\nJOINT b\n{\nOFFSET 0 9 0\nCHANNELS 1 Yposition\n}\n}\nMOTION\n"
      "Frames: 2\nFrame Time: 1\n1 9\n1 9 5\n"};
  for (const std::string& text : texts) {
    const std::string said = " " + listing(read_or_fail(text));
    for (const std::string wrong : {" 1 values", " 1 joints", " 1 channels", " 1 '}' are", " 1 names", " 1 frames", " 1 NUL bytes", " 1 rows"}) {
      EXPECT_EQ(said.find(wrong), std::string::npos) << said;
    }
  }
}

}  // namespace
}  // namespace marey
