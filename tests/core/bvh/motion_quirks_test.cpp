// Quirks of motion sections beyond the rows of ../shared/bvh-in-the-wild.md, which wild_*_test.cpp follows.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/core/bvh/bvh_texts.h"

namespace marey {
namespace {

using namespace test;
using Code = DiagnosticCode;

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

TEST(MotionQuirk, FramesZero) {
  const BvhClip clip = read_or_fail(one_joint_file("0", ""));
  EXPECT_EQ(clip.motion.frame_count(), 0);
  expect_no_warnings(clip);
  EXPECT_EQ(written(clip), one_joint_file("0", ""));
}

TEST(MotionQuirk, FrameCountThatIsNone) {
  for (const std::string count : {"-5", "many", "2.5", ""}) {
    const BvhClip clip = read_or_fail(one_joint_file(count, "1 2 3\n4 5 6\n7 8 9\n"));
    EXPECT_EQ(rows_of(clip), three_rows()) << count;
    EXPECT_TRUE(clip.diagnostics.contains(Code::MissingFrameCount)) << count;
    EXPECT_EQ(written(clip), one_joint_file("3", "1 2 3\n4 5 6\n7 8 9\n"));
  }
}

TEST(MotionQuirk, MissingFramesAndFrameTimeLines) {
  const BvhClip clip = read_or_fail(with_motion("MOTION\n1 2 3\n4 5 6\n7 8 9\n"));
  EXPECT_EQ(rows_of(clip), three_rows());
  EXPECT_EQ(clip.motion.frame_time_s(), 1.0 / 30.0);
  expect_finding(clip, Code::MissingFrameCount, {12, 1});
  expect_finding(clip, Code::MissingFrameTime, {12, 1});
  const BvhClip swapped = read_or_fail(with_motion("MOTION\nFrame Time: 0.1\nFrames: 3\n1 2 3\n4 5 6\n7 8 9\n"));
  EXPECT_EQ(rows_of(swapped), three_rows());
  expect_no_warnings(swapped);
}

TEST(MotionQuirk, FirstFrameOnTheLineOfFrameTime) {
  expect_three_rows_silently(with_motion("MOTION\nFrames: 3\nFrame Time: 0.1 1 2 3\n4 5 6\n7 8 9\n"));
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
