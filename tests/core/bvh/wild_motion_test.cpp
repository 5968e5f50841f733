// One test per row of ../shared/bvh-in-the-wild.md that is about the motion, named after it.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/core/bvh/bvh_texts.h"

namespace marey {
namespace {

using namespace test;
using Code = DiagnosticCode;

TEST(WildRow01, FrameTimeIsKeptAsWritten) {
  const std::string text = with_motion("MOTION\nFrames: 1\nFrame Time: .0083333\n1 2 3\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.motion.frame_time_s(), 0.0083333);
  EXPECT_EQ(display_frame_rate_hz(clip.motion.frame_time_s()), 120.0);
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow02, TabsBetweenNumbers) { expect_three_rows_silently(one_joint_file("3", "\t1\t2\t3\n\t4\t5\t6\n\t7\t8\t9\n")); }

TEST(WildRow03, TrailingBlanksInRows) { expect_three_rows_silently(one_joint_file("3", "1 2 3 \n4 5 6 \n7 8 9 \n")); }

TEST(WildRow04, MixedLineEnds) { expect_three_rows_silently(one_joint_file("3", "1 2 3\n4 5 6\r\n7 8 9\r\n")); }

TEST(WildRow05, TabsAndBlanksBehindTheKeywords) {
  expect_three_rows_silently(with_motion("MOTION\nFrames:\t3\nFrame Time:   0.04\n1 2 3\n4 5 6\n7 8 9\n"));
  expect_three_rows_silently(with_motion("MOTION\nFrames :3\nFrame  Time\t: 0.04\n1 2 3\n4 5 6\n7 8 9\n"));
}

TEST(WildRow06, NoBlankBehindFrames) {
  expect_three_rows_silently(with_motion("MOTION\nFrames:3\nFrame Time:0.04\n1 2 3\n4 5 6\n7 8 9\n"));
}

TEST(WildRow14, KeywordCase) {
  const BvhClip clip = read_or_fail(with_motion("motion\nframes: 1\nFRAME TIME: 0.04\n1 2 3\n"));
  EXPECT_EQ(clip.motion.frame_time_s(), 0.04);
  expect_finding(clip, Code::KeywordCase, {11, 1}, 4);
}

TEST(WildRow23, ExponentsInRows) {
  const std::string text = one_joint_file("2", "8.88178e-016 1E3 -1.5e+02\n8.88178e-016 2 3\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), (Rows{{8.88178e-16, 1000, -150}, {8.88178e-16, 2, 3}}));
  expect_no_warnings(clip);
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow24, SmallestNumbers) {
  const std::string text = one_joint_file("1", "-1.31542e-47 4.9406564584124654e-324 1e-310\n");
  EXPECT_EQ(rows_of(read_or_fail(text)), (Rows{{-1.31542e-47, 4.9406564584124654e-324, 1e-310}}));
  EXPECT_EQ(written(read_or_fail(text)), text);
  const std::string too_small = one_joint_file("1", "1e-400 0 0\n");
  EXPECT_EQ(rows_of(read_or_fail(too_small)), (Rows{{0, 0, 0}}));
  expect_finding(read_or_fail(too_small), Code::NumberRange, {14, 1});
  EXPECT_EQ(written(read_or_fail(too_small)), too_small);
}

TEST(WildRow25, NumbersRunTogether) {
  const std::string text = one_joint_file("2", "1.5 0.0-7.509\n2.5 3.5-4.5\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), (Rows{{1.5, 0, -7.509}, {2.5, 3.5, -4.5}}));
  expect_finding(clip, Code::NumbersRunTogether, {14, 8}, 2);
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow25, EditedNumberRunTogetherGetsItsBlank) {
  BvhClip clip = read_or_fail(one_joint_file("2", "1.5 0.0-7.509\n2.5 3.5-4.5\n"));
  clip.motion.channel_samples(2)[0] = 7.5;
  EXPECT_EQ(rows_of(read_or_fail(written(clip))), rows_of(clip));
}

TEST(WildRow26, DecimalCommas) {
  const std::string text = one_joint_file("2", "1,5 -0,25 3\n4,0 5,125 6,5\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), (Rows{{1.5, -0.25, 3}, {4, 5.125, 6.5}}));
  expect_finding(clip, Code::DecimalComma, {14, 1});
  EXPECT_EQ(written(clip), text);
  BvhClip edited = clip;
  edited.motion.channel_samples(0)[0] = 1.0 / 3.0;
  EXPECT_EQ(rows_of(read_or_fail(written(edited))), rows_of(edited));
}

TEST(WildRow26, CommasThatSeparate) {
  const std::string text = one_joint_file("2", "1.5, -0.25, 3\n4.0, 5.125, 6.5\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), (Rows{{1.5, -0.25, 3}, {4, 5.125, 6.5}}));
  expect_finding(clip, Code::CommaBetweenNumbers, {14, 4});
  EXPECT_EQ(rows_of(read_or_fail(one_joint_file("2", "1,2,3\n4,5,6\n"))), (Rows{{1, 2, 3}, {4, 5, 6}}));
}

TEST(WildRow27, WholeNumbersAndNegativeZero) {
  const std::string text = one_joint_file("2", "1 -0 3\n0 -0 -5\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_TRUE(std::signbit(clip.motion.sample(1, 0)));
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow28, MoreRowsThanDeclared) {
  const BvhClip clip = read_or_fail(one_joint_file("2", "1 2 3\n4 5 6\n7 8 9\n"));
  EXPECT_EQ(rows_of(clip), three_rows());
  expect_finding(clip, Code::FrameCountMismatch, {12, 9});
  EXPECT_EQ(written(clip), one_joint_file("3", "1 2 3\n4 5 6\n7 8 9\n"));
}

TEST(WildRow29, FewerRowsThanDeclared) {
  const BvhClip clip = read_or_fail(one_joint_file("2000000000", "1 2 3\n4 5 6\n7 8 9\n"));
  EXPECT_EQ(rows_of(clip), three_rows());
  expect_finding(clip, Code::FrameCountMismatch, {12, 9});
}

TEST(WildRow29, LastRowCutOff) {
  const BvhClip clip = read_or_fail(one_joint_file("4", "1 2 3\n4 5 6\n7 8 9\n10 11\n"));
  EXPECT_EQ(rows_of(clip), three_rows());
  expect_finding(clip, Code::PartialFrame, {17, 1});
  expect_finding(clip, Code::FrameCountMismatch);
}

TEST(WildRow29, FrameOverSeveralLines) {
  expect_three_rows_silently(one_joint_file("3", "1 2 3\n4\n5\n6\n7 8 9\n"));
  expect_three_rows_silently(one_joint_file("3", "1\n2 3\n4\n5 6\n7\n8 9\n"));
  expect_three_rows_silently(one_joint_file("3", "1\n2\n3\n4\n5\n6\n7\n8\n9\n"));
  expect_three_rows_silently(one_joint_file("3", "1 2\n3 4\n5 6 7\n8\n9\n"));
}

TEST(WildRow30, FrameTimeThatIsNone) {
  for (const std::string time : {"0", "-0.5", "nan", "0.0"}) {
    const BvhClip clip = read_or_fail(with_motion("MOTION\nFrames: 1\nFrame Time: " + time + "\n1 2 3\n"));
    EXPECT_EQ(clip.motion.frame_time_s(), 1.0 / 30.0);
    EXPECT_EQ(rows_of(clip), (Rows{{1, 2, 3}}));
    expect_finding(clip, Code::FrameTimeNotPositive, {13, 13});
    expect_round_trip(clip.skeleton, clip.motion, clip.style);
  }
}

TEST(WildRow30, FrameRateTypedAsTime) {
  const BvhClip clip = read_or_fail(with_motion("MOTION\nFrames: 1\nFrame Time: 25\n1 2 3\n"));
  EXPECT_EQ(clip.motion.frame_time_s(), 1.0 / 25.0);
  expect_finding(clip, Code::FrameTimeLooksLikeRate, {13, 13});
  const BvhClip pose = read_or_fail(with_motion("MOTION\nFrames: 1\nFrame Time: 1.0\n1 2 3\n"));
  EXPECT_EQ(pose.motion.frame_time_s(), 1.0);
  expect_no_warnings(pose);
}

TEST(WildRow31, BlankLinesAroundMotion) {
  expect_three_rows_silently(with_motion("\n\nMOTION\n\nFrames: 3\n\nFrame Time: 0.008\n\n1 2 3\n4 5 6\n7 8 9\n"));
}

TEST(WildRow32, BlankLinesBetweenFramesAndAtTheEnd) {
  expect_three_rows_silently(one_joint_file("3", "1 2 3\n\n4 5 6\n7 8 9\n\n\n"));
}

TEST(WildRow33, NoLineEndAtTheEnd) { expect_three_rows_silently(one_joint_file("3", "1 2 3\n4 5 6\n7 8 9")); }

TEST(WildRow34, HierarchyOnly) {
  const BvhClip clip = read_or_fail(kOneJoint);
  EXPECT_EQ(clip.motion.frame_count(), 0);
  EXPECT_EQ(clip.motion.channel_count(), 3);
  expect_finding(clip, Code::MissingMotion, {11, 1});
  EXPECT_EQ(written(clip), kOneJoint);
}

TEST(WildRow34, NothingBehindMotion) {
  const BvhClip clip = read_or_fail(with_motion("MOTION\n"));
  EXPECT_EQ(clip.motion.frame_count(), 0);
  expect_finding(clip, Code::MissingMotion);
  EXPECT_EQ(written(clip), with_motion("MOTION\n"));
}

TEST(WildRow35, CommentsBetweenRows) {
  const std::string text = one_joint_file("3", "# first\n1 2 3\n4 5 6 # second\n// third\n7 8 9\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), three_rows());
  expect_finding(clip, Code::Comment, {14, 1}, 3);
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow36, LongLines) {
  std::string hierarchy = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3000";
  std::string row;
  for (int i = 0; i < 3000; ++i) {
    hierarchy += " Xrotation";
    row += std::to_string(i) + ".123456 ";
  }
  const std::string text = hierarchy + "\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION\nFrames: 3\nFrame Time: 0.1\n" + row + "\n" + row + "\n" + row + "\n";
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.motion.sample(2999, 2), 2999.123456);
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow42, NotANumber) {
  const BvhClip clip = read_or_fail(one_joint_file("3", "1 nan 3\n4 5 -1.#IND\ninf 8 9\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{1, 0, 3}, {4, 5, 3}, {4, 8, 9}}));
  expect_finding(clip, Code::NotFinite, {14, 3}, 3);
  EXPECT_EQ(written(clip), one_joint_file("3", "1 0 3\n4 5 3\n4 8 9\n"));
  const BvhClip first = read_or_fail(one_joint_file("1", "nan 2 3\n"));
  EXPECT_EQ(rows_of(first), (Rows{{0, 2, 3}}));
}

TEST(WildRow42, Utf16) {
  const std::string text = one_joint_file("2", "1 2 3\n4 5 6\n");
  for (const bool little_endian : {true, false}) {
    std::string bytes = little_endian ? "\xff\xfe" : "\xfe\xff";
    for (const char c : text) bytes += little_endian ? std::string({c, '\0'}) : std::string({'\0', c});
    const BvhClip clip = read_or_fail(bytes);
    EXPECT_EQ(rows_of(clip), (Rows{{1, 2, 3}, {4, 5, 6}}));
    expect_finding(clip, Code::Utf16Text, {1, 1});
    EXPECT_EQ(written(clip), bytes);
  }
}

TEST(WildRow42, Utf16KeepsNamesBeyondAscii) {
  // "Голова𝄞" as UTF-16 little endian in place of "Hips".
  const std::string name_utf16("\x13\x04\x3e\x04\x3b\x04\x3e\x04\x32\x04\x30\x04\x34\xd8\x1e\xdd", 16);
  std::string bytes = "\xff\xfe";
  const std::string text = one_joint_file("1", "1 2 3\n");
  const std::size_t at = text.find("Hips");
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i == at) bytes += name_utf16;
    if (i < at || i >= at + 4) bytes += std::string({text[i], '\0'});
  }
  const BvhClip clip = read_or_fail(bytes);
  EXPECT_EQ(clip.skeleton.name(0), "Голова\xf0\x9d\x84\x9e");
  EXPECT_EQ(written(clip), bytes);
}

TEST(WildRow42, TrailingNulBytes) {
  const std::string text = one_joint_file("3", "1 2 3\n4 5 6\n7 8 9\n") + std::string(5, '\0');
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), three_rows());
  expect_finding(clip, Code::TrailingNul, {17, 1});
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow43, BareCarriageReturns) {
  std::string text = one_joint_file("3", "1 2 3\n4 5 6\n7 8 9\n");
  for (char& c : text) c = c == '\n' ? '\r' : c;
  expect_three_rows_silently(text);
}

TEST(WildRow44, TextBehindTheMotion) {
  const std::string text = one_joint_file("3", "1 2 3\n4 5 6\n7 8 9\nfoot plants: 3 5\n1 2\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), three_rows());
  expect_finding(clip, Code::TextAfterMotion, {17, 1});
  EXPECT_FALSE(clip.diagnostics.contains(Code::FrameCountMismatch));
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow44, KeyFrameListsBehindTheMotion) {
  const std::string text = one_joint_file("3", "1 2 3\n4 5 6\n7 8 9\n4 0 3 5 9\n1 0\n2 0 7\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), three_rows());
  expect_finding(clip, Code::TextAfterMotion, {17, 1});
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow47, AllFramesOnOneLine) { expect_three_rows_silently(one_joint_file("3", "1 2 3 4 5 6 7 8 9\n")); }

TEST(WildRow47, TwoFramesPerLine) {
  const BvhClip clip = read_or_fail(one_joint_file("4", "1 2 3 4 5 6\n7 8 9 1 1 1\n"));
  EXPECT_EQ(clip.motion.frame_count(), 4);
  expect_no_warnings(clip);
  EXPECT_EQ(written(clip), one_joint_file("4", "1 2 3 4 5 6\n7 8 9 1 1 1\n"));
}

TEST(WildRow49, NoMotionKeyword) {
  const BvhClip clip = read_or_fail(with_motion("Frames: 3\nFrame Time: 0.1\n1 2 3\n4 5 6\n7 8 9\n"));
  EXPECT_EQ(rows_of(clip), three_rows());
  expect_finding(clip, Code::MissingMotion, {11, 1});
  EXPECT_NE(written(clip).find("MOTION\n"), std::string::npos);
}

TEST(WildRow50, MoreValuesPerRowThanChannels) {
  const BvhClip clip = read_or_fail(one_joint_file("3", "1 2 3 0 0\n4 5 6 0 0\n7 8 9 0 0\n"));
  EXPECT_EQ(rows_of(clip), three_rows());
  expect_finding(clip, Code::SurplusValues, {14, 1}, 3);
  EXPECT_EQ(written(clip), one_joint_file("3", "1 2 3\n4 5 6\n7 8 9\n"));
}

TEST(WildRow52, AccumulatedAngles) {
  const BvhClip clip = read_or_fail(one_joint_file("1", "2535.25 -1081 720\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{2535.25, -1081, 720}}));
  expect_no_warnings(clip);
}

}  // namespace
}  // namespace marey
