// What commas mean is decided by many lines together, and a number is never read wrong in silence.
#include <gtest/gtest.h>

#include <string>

#include "tests/core/bvh/bvh_texts.h"

namespace marey {
namespace {

using namespace test;
using Code = DiagnosticCode;

TEST(Commas, ABadWordInTheFirstLineLeavesTheOthersTheirCommas) {
  for (const std::string word : {"x", "nan", "-1.#IND"}) {
    const BvhClip clip = read_or_fail(one_joint_file("2", "1,5 " + word + " 3,5\n4,5 5,5 6,5\n"));
    EXPECT_EQ(rows_of(clip), (Rows{{1.5, 0, 3.5}, {4.5, 5.5, 6.5}})) << word;
    expect_finding(clip, Code::DecimalComma, {14, 1});
    expect_finding(clip, word == "x" ? Code::BadNumber : Code::NotFinite, {14, 5});
  }
}

TEST(Commas, AWordThatOpensTheRowsLeavesTheOthersTheirCommas) {
  const BvhClip clip = read_or_fail(one_joint_file("2", "abc 2,5 3,5\n4,5 5,5 6,5\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{0, 2.5, 3.5}, {4.5, 5.5, 6.5}}));
  expect_finding(clip, Code::BadNumber, {14, 1});
}

TEST(Commas, BesideAsManyPointsTheyAreNoNumbers) {
  const BvhClip clip = read_or_fail(one_joint_file("2", "1.5 2.5 3.5\n1,5 2,5 3,5\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{1.5, 2.5, 3.5}, {1.5, 2.5, 3.5}}));
  expect_finding(clip, Code::BadNumber, {15, 1}, 3);
  EXPECT_FALSE(clip.diagnostics.contains(Code::CommaBetweenNumbers));
  const BvhClip reversed = read_or_fail(one_joint_file("2", "1,5 2,5 3,5\n4.5 5.5 6.5\n"));
  EXPECT_EQ(rows_of(reversed), (Rows{{0, 0, 0}, {4.5, 5.5, 6.5}}));
  expect_finding(reversed, Code::BadNumber, {14, 1}, 3);
}

TEST(Commas, WithinOneLineTheyAreNoNumbersBesidePoints) {
  const BvhClip clip = read_or_fail(one_joint_file("2", "1.5 2,5 3.5\n4.5 5.5 6.5\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{1.5, 0, 3.5}, {4.5, 5.5, 6.5}}));
  expect_finding(clip, Code::BadNumber, {14, 5});
}

TEST(Commas, OnePointAmongManyCommasIsTheBadNumber) {
  const BvhClip clip = read_or_fail(one_joint_file("3", "1,5 2,5 3,5\n4,5 5.5 6,5\n7,5 8,5 9,5\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{1.5, 2.5, 3.5}, {4.5, 2.5, 6.5}, {7.5, 8.5, 9.5}}));
  expect_finding(clip, Code::BadNumber, {15, 5});
}

TEST(Commas, GroupingThousandsAreNoNumbers) {
  const BvhClip clip = read_or_fail(one_joint_file("2", "1,234.5 2.5 3.5\n4.5 5.5 6.5\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{0, 2.5, 3.5}, {4.5, 5.5, 6.5}}));
  expect_finding(clip, Code::BadNumber, {14, 1});
}

TEST(Commas, WithoutBlanksTheySeparate) {
  const BvhClip clip = read_or_fail(one_joint_file("2", "1.5,2.5,3.5\n4.5,5.5,6.5\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{1.5, 2.5, 3.5}, {4.5, 5.5, 6.5}}));
  expect_finding(clip, Code::CommaBetweenNumbers, {14, 4});
}

TEST(Commas, InAnOffsetOfFourValuesStayDecimal) {
  const BvhClip clip = read_or_fail(file_with_lines("  End Site\n  {\n    OFFSET 0,5 1,5 2,5 0\n  }\n", 6));
  EXPECT_EQ(clip.skeleton.node(1).offset, glm::dvec3(0.5, 1.5, 2.5));
}

}  // namespace
}  // namespace marey
