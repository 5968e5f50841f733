// One test per quirk of real motion sections, named after it; the numbers are the rows of ../shared/bvh-in-the-wild.md.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/core/bvh/bvh_texts.h"

namespace marey {
namespace {

using namespace test;
using Code = DiagnosticCode;

const Rows kThreeRows = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};

std::string with_header(std::string_view motion) { return std::string(kOneJoint) + std::string(motion); }

/// Expects three rows 1..9, no warnings, and the same bytes when written.
void expect_read_silently(const std::string& text) {
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), kThreeRows) << text;
  expect_no_warnings(clip);
  EXPECT_EQ(written(clip), text);
}

TEST(MotionQuirk, Row01FrameTimeIsKeptAsWritten) {
  const std::string text = with_header("MOTION\nFrames: 1\nFrame Time: .0083333\n1 2 3\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.motion.frame_time_s(), 0.0083333);
  EXPECT_EQ(display_frame_rate_hz(clip.motion.frame_time_s()), 120.0);
  EXPECT_EQ(written(clip), text);
}

TEST(MotionQuirk, Row02TabsBetweenNumbers) { expect_read_silently(one_joint_file("3", "\t1\t2\t3\n\t4\t5\t6\n\t7\t8\t9\n")); }

TEST(MotionQuirk, Row03TrailingBlanksInRows) { expect_read_silently(one_joint_file("3", "1 2 3 \n4 5 6 \n7 8 9 \n")); }

TEST(MotionQuirk, Row04MixedLineEnds) { expect_read_silently(one_joint_file("3", "1 2 3\n4 5 6\r\n7 8 9\r\n")); }

TEST(MotionQuirk, Row05TabsAndBlanksBehindTheKeywords) {
  expect_read_silently(with_header("MOTION\nFrames:\t3\nFrame Time:   0.04\n1 2 3\n4 5 6\n7 8 9\n"));
  expect_read_silently(with_header("MOTION\nFrames :3\nFrame  Time\t: 0.04\n1 2 3\n4 5 6\n7 8 9\n"));
}

TEST(MotionQuirk, Row06NoBlankBehindFrames) {
  expect_read_silently(with_header("MOTION\nFrames:3\nFrame Time:0.04\n1 2 3\n4 5 6\n7 8 9\n"));
}

TEST(MotionQuirk, Row14KeywordCase) {
  const BvhClip clip = read_or_fail(with_header("motion\nframes: 1\nFRAME TIME: 0.04\n1 2 3\n"));
  EXPECT_EQ(clip.motion.frame_time_s(), 0.04);
  expect_finding(clip, Code::KeywordCase, {11, 1}, 4);
}

TEST(MotionQuirk, Row23ExponentsInRows) {
  const std::string text = one_joint_file("2", "8.88178e-016 1E3 -1.5e+02\n8.88178e-016 2 3\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), (Rows{{8.88178e-16, 1000, -150}, {8.88178e-16, 2, 3}}));
  expect_no_warnings(clip);
  EXPECT_EQ(written(clip), text);
}

TEST(MotionQuirk, Row24SmallestNumbers) {
  const std::string text = one_joint_file("1", "-1.31542e-47 4.9406564584124654e-324 1e-310\n");
  EXPECT_EQ(rows_of(read_or_fail(text)), (Rows{{-1.31542e-47, 4.9406564584124654e-324, 1e-310}}));
  EXPECT_EQ(written(read_or_fail(text)), text);
  const std::string too_small = one_joint_file("1", "1e-400 0 0\n");
  EXPECT_EQ(rows_of(read_or_fail(too_small)), (Rows{{0, 0, 0}}));
  expect_finding(read_or_fail(too_small), Code::NumberRange, {14, 1});
  EXPECT_EQ(written(read_or_fail(too_small)), too_small);
}

TEST(MotionQuirk, Row25NumbersRunTogether) {
  const std::string text = one_joint_file("2", "1.5 0.0-7.509\n2.5 3.5-4.5\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), (Rows{{1.5, 0, -7.509}, {2.5, 3.5, -4.5}}));
  expect_finding(clip, Code::NumbersRunTogether, {14, 8}, 2);
  EXPECT_EQ(written(clip), text);
}

TEST(MotionQuirk, Row25EditedNumberRunTogetherGetsItsBlank) {
  BvhClip clip = read_or_fail(one_joint_file("2", "1.5 0.0-7.509\n2.5 3.5-4.5\n"));
  clip.motion.channel_samples(2)[0] = 7.5;
  EXPECT_EQ(rows_of(read_or_fail(written(clip))), rows_of(clip));
}

TEST(MotionQuirk, Row26DecimalCommas) {
  const std::string text = one_joint_file("2", "1,5 -0,25 3\n4,0 5,125 6,5\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), (Rows{{1.5, -0.25, 3}, {4, 5.125, 6.5}}));
  expect_finding(clip, Code::DecimalComma, {14, 1});
  EXPECT_EQ(written(clip), text);
  BvhClip edited = clip;
  edited.motion.channel_samples(0)[0] = 1.0 / 3.0;
  EXPECT_EQ(rows_of(read_or_fail(written(edited))), rows_of(edited));
}

TEST(MotionQuirk, Row26CommasThatSeparate) {
  const std::string text = one_joint_file("2", "1.5, -0.25, 3\n4.0, 5.125, 6.5\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), (Rows{{1.5, -0.25, 3}, {4, 5.125, 6.5}}));
  expect_finding(clip, Code::CommaBetweenNumbers, {14, 4});
  EXPECT_EQ(rows_of(read_or_fail(one_joint_file("2", "1,2,3\n4,5,6\n"))), (Rows{{1, 2, 3}, {4, 5, 6}}));
}

TEST(MotionQuirk, Row27WholeNumbersAndNegativeZero) {
  const std::string text = one_joint_file("2", "1 -0 3\n0 -0 -5\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_TRUE(std::signbit(clip.motion.sample(1, 0)));
  EXPECT_EQ(written(clip), text);
}

TEST(MotionQuirk, Row28MoreRowsThanDeclared) {
  const BvhClip clip = read_or_fail(one_joint_file("2", "1 2 3\n4 5 6\n7 8 9\n"));
  EXPECT_EQ(rows_of(clip), kThreeRows);
  expect_finding(clip, Code::FrameCountMismatch, {12, 9});
  EXPECT_EQ(written(clip), one_joint_file("3", "1 2 3\n4 5 6\n7 8 9\n"));
}

TEST(MotionQuirk, Row29FewerRowsThanDeclared) {
  const BvhClip clip = read_or_fail(one_joint_file("2000000000", "1 2 3\n4 5 6\n7 8 9\n"));
  EXPECT_EQ(rows_of(clip), kThreeRows);
  expect_finding(clip, Code::FrameCountMismatch, {12, 9});
}

TEST(MotionQuirk, Row29LastRowCutOff) {
  const BvhClip clip = read_or_fail(one_joint_file("4", "1 2 3\n4 5 6\n7 8 9\n10 11\n"));
  EXPECT_EQ(rows_of(clip), kThreeRows);
  expect_finding(clip, Code::PartialFrame, {17, 1});
  expect_finding(clip, Code::FrameCountMismatch);
}

TEST(MotionQuirk, Row29FrameOverSeveralLines) {
  expect_read_silently(one_joint_file("3", "1 2 3\n4\n5\n6\n7 8 9\n"));
  expect_read_silently(one_joint_file("3", "1\n2 3\n4\n5 6\n7\n8 9\n"));
  expect_read_silently(one_joint_file("3", "1\n2\n3\n4\n5\n6\n7\n8\n9\n"));
  expect_read_silently(one_joint_file("3", "1 2\n3 4\n5 6 7\n8\n9\n"));
}

TEST(MotionQuirk, ShortRowIsPointedAt) {
  const BvhClip clip = read_or_fail(one_joint_file("4", "1 2 3\n4 5\n7 8 9\n1 1 1\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{1, 2, 3}, {4, 5, 3}, {7, 8, 9}, {1, 1, 1}}));
  expect_finding(clip, Code::RowLength, {15, 1});
  EXPECT_EQ(written(clip), one_joint_file("4", "1 2 3\n4 5 3\n7 8 9\n1 1 1\n"));
}

TEST(MotionQuirk, LongRowIsPointedAt) {
  const BvhClip clip = read_or_fail(one_joint_file("4", "1 2 3\n4 5 6 6\n7 8 9\n1 1 1 1 1\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {1, 1, 1}}));
  expect_finding(clip, Code::RowLength, {15, 7}, 2);
}

TEST(MotionQuirk, Row30FrameTimeThatIsNone) {
  for (const std::string time : {"0", "-0.5", "nan", "0.0"}) {
    const BvhClip clip = read_or_fail(with_header("MOTION\nFrames: 1\nFrame Time: " + time + "\n1 2 3\n"));
    EXPECT_EQ(clip.motion.frame_time_s(), 1.0 / 30.0);
    EXPECT_EQ(rows_of(clip), (Rows{{1, 2, 3}}));
    expect_finding(clip, Code::FrameTimeNotPositive, {13, 13});
    expect_round_trip(clip.skeleton, clip.motion, clip.style);
  }
}

TEST(MotionQuirk, Row30FrameRateTypedAsTime) {
  const BvhClip clip = read_or_fail(with_header("MOTION\nFrames: 1\nFrame Time: 25\n1 2 3\n"));
  EXPECT_EQ(clip.motion.frame_time_s(), 1.0 / 25.0);
  expect_finding(clip, Code::FrameTimeLooksLikeRate, {13, 13});
  const BvhClip pose = read_or_fail(with_header("MOTION\nFrames: 1\nFrame Time: 1.0\n1 2 3\n"));
  EXPECT_EQ(pose.motion.frame_time_s(), 1.0);
  expect_no_warnings(pose);
}

TEST(MotionQuirk, Row31BlankLinesAroundMotion) {
  expect_read_silently(with_header("\n\nMOTION\n\nFrames: 3\n\nFrame Time: 0.008\n\n1 2 3\n4 5 6\n7 8 9\n"));
}

TEST(MotionQuirk, Row32BlankLinesBetweenFramesAndAtTheEnd) {
  expect_read_silently(one_joint_file("3", "1 2 3\n\n4 5 6\n7 8 9\n\n\n"));
}

TEST(MotionQuirk, Row33NoLineEndAtTheEnd) { expect_read_silently(one_joint_file("3", "1 2 3\n4 5 6\n7 8 9")); }

TEST(MotionQuirk, Row34HierarchyOnly) {
  const BvhClip clip = read_or_fail(kOneJoint);
  EXPECT_EQ(clip.motion.frame_count(), 0);
  EXPECT_EQ(clip.motion.channel_count(), 3);
  expect_finding(clip, Code::MissingMotion, {11, 1});
  EXPECT_EQ(written(clip), kOneJoint);
}

TEST(MotionQuirk, Row34NothingBehindMotion) {
  const BvhClip clip = read_or_fail(with_header("MOTION\n"));
  EXPECT_EQ(clip.motion.frame_count(), 0);
  expect_finding(clip, Code::MissingMotion);
  EXPECT_EQ(written(clip), with_header("MOTION\n"));
}

TEST(MotionQuirk, Row35CommentsBetweenRows) {
  const std::string text = one_joint_file("3", "# first\n1 2 3\n4 5 6 # second\n// third\n7 8 9\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), kThreeRows);
  expect_finding(clip, Code::Comment, {14, 1}, 3);
  EXPECT_EQ(written(clip), text);
}

TEST(MotionQuirk, Row36LongLines) {
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

TEST(MotionQuirk, Row42NotANumber) {
  const BvhClip clip = read_or_fail(one_joint_file("3", "1 nan 3\n4 5 -1.#IND\ninf 8 9\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{1, 0, 3}, {4, 5, 3}, {4, 8, 9}}));
  expect_finding(clip, Code::NotFinite, {14, 3}, 3);
  EXPECT_EQ(written(clip), one_joint_file("3", "1 0 3\n4 5 3\n4 8 9\n"));
  const BvhClip first = read_or_fail(one_joint_file("1", "nan 2 3\n"));
  EXPECT_EQ(rows_of(first), (Rows{{0, 2, 3}}));
}

TEST(MotionQuirk, NumbersBeyondDouble) {
  const BvhClip clip = read_or_fail(one_joint_file("2", "1 2 3\n4 1e999 6\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{1, 2, 3}, {4, 2, 6}}));
  expect_finding(clip, Code::NumberRange, {15, 3});
}

TEST(MotionQuirk, WordsThatAreNoNumbers) {
  const BvhClip clip = read_or_fail(one_joint_file("3", "1 2 3\n4 abc 6\n1.2.3 8 9x\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{1, 2, 3}, {4, 2, 6}, {4, 8, 6}}));
  expect_finding(clip, Code::BadNumber, {15, 3}, 3);
}

TEST(MotionQuirk, Row42Utf16) {
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

TEST(MotionQuirk, Row42Utf16KeepsNamesBeyondAscii) {
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

TEST(MotionQuirk, Row42TrailingNulBytes) {
  const std::string text = one_joint_file("3", "1 2 3\n4 5 6\n7 8 9\n") + std::string(5, '\0');
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), kThreeRows);
  expect_finding(clip, Code::TrailingNul, {17, 1});
  EXPECT_EQ(written(clip), text);
}

TEST(MotionQuirk, Row43BareCarriageReturns) {
  std::string text = one_joint_file("3", "1 2 3\n4 5 6\n7 8 9\n");
  for (char& c : text) c = c == '\n' ? '\r' : c;
  expect_read_silently(text);
}

TEST(MotionQuirk, Row44TextBehindTheMotion) {
  const std::string text = one_joint_file("3", "1 2 3\n4 5 6\n7 8 9\nfoot plants: 3 5\n1 2\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), kThreeRows);
  expect_finding(clip, Code::TextAfterMotion, {17, 1});
  EXPECT_FALSE(clip.diagnostics.contains(Code::FrameCountMismatch));
  EXPECT_EQ(written(clip), text);
}

TEST(MotionQuirk, Row44KeyFrameListsBehindTheMotion) {
  const std::string text = one_joint_file("3", "1 2 3\n4 5 6\n7 8 9\n4 0 3 5 9\n1 0\n2 0 7\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), kThreeRows);
  expect_finding(clip, Code::TextAfterMotion, {17, 1});
  EXPECT_EQ(written(clip), text);
}

TEST(MotionQuirk, Row47AllFramesOnOneLine) { expect_read_silently(one_joint_file("3", "1 2 3 4 5 6 7 8 9\n")); }

TEST(MotionQuirk, Row47TwoFramesPerLine) {
  const BvhClip clip = read_or_fail(one_joint_file("4", "1 2 3 4 5 6\n7 8 9 1 1 1\n"));
  EXPECT_EQ(clip.motion.frame_count(), 4);
  expect_no_warnings(clip);
  EXPECT_EQ(written(clip), one_joint_file("4", "1 2 3 4 5 6\n7 8 9 1 1 1\n"));
}

TEST(MotionQuirk, Row49NoMotionKeyword) {
  const BvhClip clip = read_or_fail(with_header("Frames: 3\nFrame Time: 0.1\n1 2 3\n4 5 6\n7 8 9\n"));
  EXPECT_EQ(rows_of(clip), kThreeRows);
  expect_finding(clip, Code::MissingMotion, {11, 1});
  EXPECT_NE(written(clip).find("MOTION\n"), std::string::npos);
}

TEST(MotionQuirk, Row50MoreValuesPerRowThanChannels) {
  const BvhClip clip = read_or_fail(one_joint_file("3", "1 2 3 0 0\n4 5 6 0 0\n7 8 9 0 0\n"));
  EXPECT_EQ(rows_of(clip), kThreeRows);
  expect_finding(clip, Code::SurplusValues, {14, 1}, 3);
  EXPECT_EQ(written(clip), one_joint_file("3", "1 2 3\n4 5 6\n7 8 9\n"));
}

TEST(MotionQuirk, Row52AccumulatedAngles) {
  const BvhClip clip = read_or_fail(one_joint_file("1", "2535.25 -1081 720\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{2535.25, -1081, 720}}));
  expect_no_warnings(clip);
}

TEST(MotionQuirk, FramesZero) {
  const BvhClip clip = read_or_fail(one_joint_file("0", ""));
  EXPECT_EQ(clip.motion.frame_count(), 0);
  expect_no_warnings(clip);
  EXPECT_EQ(written(clip), one_joint_file("0", ""));
}

TEST(MotionQuirk, FrameCountThatIsNone) {
  for (const std::string count : {"-5", "many", "2.5", ""}) {
    const BvhClip clip = read_or_fail(one_joint_file(count, "1 2 3\n4 5 6\n7 8 9\n"));
    EXPECT_EQ(rows_of(clip), kThreeRows) << count;
    EXPECT_TRUE(clip.diagnostics.contains(Code::MissingFrameCount)) << count;
    EXPECT_EQ(written(clip), one_joint_file("3", "1 2 3\n4 5 6\n7 8 9\n"));
  }
}

TEST(MotionQuirk, MissingFramesAndFrameTimeLines) {
  const BvhClip clip = read_or_fail(with_header("MOTION\n1 2 3\n4 5 6\n7 8 9\n"));
  EXPECT_EQ(rows_of(clip), kThreeRows);
  EXPECT_EQ(clip.motion.frame_time_s(), 1.0 / 30.0);
  expect_finding(clip, Code::MissingFrameCount, {12, 1});
  expect_finding(clip, Code::MissingFrameTime, {12, 1});
  const BvhClip swapped = read_or_fail(with_header("MOTION\nFrame Time: 0.1\nFrames: 3\n1 2 3\n4 5 6\n7 8 9\n"));
  EXPECT_EQ(rows_of(swapped), kThreeRows);
  expect_no_warnings(swapped);
}

TEST(MotionQuirk, FirstFrameOnTheLineOfFrameTime) {
  expect_read_silently(with_header("MOTION\nFrames: 3\nFrame Time: 0.1 1 2 3\n4 5 6\n7 8 9\n"));
}

TEST(MotionQuirk, ManyBadRowsMakeFewFindings) {
  std::string rows;
  for (int i = 0; i < 20'001; ++i) rows += i % 2 == 0 ? "1 2 3\n" : "1 x\n";
  const BvhClip clip = read_or_fail(one_joint_file("20001", rows));
  EXPECT_EQ(clip.motion.frame_count(), 20'001);
  EXPECT_LE(clip.diagnostics.list().size(), 4U);
  expect_finding(clip, Code::RowLength, {15, 1}, 10'000);
}

}  // namespace
}  // namespace marey
