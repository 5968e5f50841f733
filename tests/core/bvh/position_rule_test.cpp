#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/core/bvh/bvh_texts.h"

namespace marey {
namespace {

using namespace test;
using Code = DiagnosticCode;

/// A root and a child, both with three positions; `row` has their six values.
std::string two_positions(const std::string& root_offset, const std::string& child_offset, const std::string& row) {
  return "HIERARCHY\nROOT a\n{\nOFFSET " + root_offset + "\nCHANNELS 3 Xposition Yposition Zposition\nJOINT b\n{\nOFFSET " +
         child_offset + "\nCHANNELS 3 Xposition Yposition Zposition\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n}\n" +
         "MOTION\nFrames: 1\nFrame Time: 0.1\n" + row + "\n";
}

TEST(PositionRule, ValuesNearTheOffsetReplaceIt) {
  const BvhClip clip = read_or_fail(two_positions("0 0 0", "0 10 0", "5 6 7 0.5 10.5 0"));
  EXPECT_EQ(clip.position_rule, PositionRule::Replace);
  expect_finding(clip, Code::PositionsReplaceOffset, {6, 1});
}

TEST(PositionRule, ZerosBesideAnOffsetAddToIt) {
  const BvhClip clip = read_or_fail(two_positions("0 0 0", "0 10 0", "5 6 7 0 0 0"));
  EXPECT_EQ(clip.position_rule, PositionRule::Add);
  expect_finding(clip, Code::PositionsAddToOffset, {6, 1});
}

TEST(PositionRule, WithoutOffsetBothRulesAgreeAndNothingIsSaid) {
  const BvhClip clip = read_or_fail(two_positions("0 0 0", "0 0 0", "5 6 7 1 2 3"));
  EXPECT_EQ(clip.position_rule, PositionRule::Replace);
  EXPECT_FALSE(clip.diagnostics.contains(Code::PositionsReplaceOffset));
}

TEST(PositionRule, RootOffsetThatWouldDoubleIsPointedOut) {
  const BvhClip clip = read_or_fail(two_positions("0 90 0", "0 0 0", "0 91 0 0 0 0"));
  EXPECT_EQ(clip.position_rule, PositionRule::Replace);
  expect_finding(clip, Code::PositionsReplaceOffset, {2, 1});
}

TEST(PositionRule, RootAndJointsAreToldApart) {
  const BvhClip clip = read_or_fail(two_positions("0 90 0", "0 10 0", "0 91 0 0.5 10.5 0"));
  std::vector<TextPlace> places;
  for (const Diagnostic& finding : clip.diagnostics.list()) {
    if (finding.code == Code::PositionsReplaceOffset) places.push_back(finding.place);
  }
  EXPECT_EQ(places, (std::vector<TextPlace>{{2, 1}, {6, 1}})) << listing(clip);
}

TEST(PositionRule, JointsThatDisagreeAreAWarning) {
  const std::string text =
      "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 0\nJOINT b\n{\nOFFSET 0 9 0\nCHANNELS 1 Yposition\n}\nJOINT c\n{\n"
      "OFFSET 0 9 0\nCHANNELS 1 Yposition\n}\nJOINT d\n{\nOFFSET 0 9 0\nCHANNELS 1 Yposition\n}\n}\n"
      "MOTION\nFrames: 1\nFrame Time: 0.1\n0 9.5 9\n";
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.position_rule, PositionRule::Replace);
  expect_finding(clip, Code::PositionsAmbiguous, {6, 1});
}

TEST(PositionRule, WithoutFramesTheDefaultHolds) {
  EXPECT_EQ(read_or_fail(kOneJoint).position_rule, PositionRule::Replace);
}

}  // namespace
}  // namespace marey
