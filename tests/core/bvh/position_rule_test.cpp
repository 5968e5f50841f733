#include <gtest/gtest.h>

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/kinematics/forward_kinematics.h"
#include "core/kinematics/pose.h"
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

/// Joints b, c and d with an OFFSET of 9 up and one position channel each; `row` has their values.
std::string three_heights(const std::string& row) {
  return
      "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 0\nJOINT b\n{\nOFFSET 0 9 0\nCHANNELS 1 Yposition\n}\nJOINT c\n{\n"
      "OFFSET 0 9 0\nCHANNELS 1 Yposition\n}\nJOINT d\n{\nOFFSET 0 9 0\nCHANNELS 1 Yposition\n}\n}\n"
      "MOTION\nFrames: 1\nFrame Time: 0.1\n" + row + "\n";
}

TEST(PositionRule, TheMajorityDecidesWhereJointsDisagree) {
  const BvhClip clip = read_or_fail(three_heights("0.5 9.5 9"));
  EXPECT_EQ(clip.position_rule, PositionRule::Replace);
  EXPECT_FALSE(has_joints_that_add(clip.skeleton));
  expect_finding(clip, Code::PositionsAmbiguous, {6, 1});
}

TEST(PositionRule, JointsThatRestAtZeroBesideOthersThatDoNotAddEachForItself) {
  const BvhClip clip = read_or_fail(three_heights("0 9.5 0"));
  EXPECT_EQ(clip.position_rule, PositionRule::PerJoint);
  expect_finding(clip, Code::PositionsAmbiguous, {6, 1});
  const std::vector<glm::dvec3> expected = {{0, 0, 0}, {0, 9, 0}, {0, 9.5, 0}, {0, 9, 0}};
  std::vector<double> block(12);
  compute_world_positions(clip.skeleton, clip.motion, {0, 1}, clip.position_rule, block);
  LocalPose local;
  WorldPose world;
  local.resize(clip.skeleton);
  world.resize(clip.skeleton);
  compute_local_pose(clip.skeleton, clip.motion, 0, clip.position_rule, local);
  compute_world_pose(clip.skeleton, local, world);
  for (std::size_t node = 0; node < expected.size(); ++node) {
    EXPECT_EQ(world.world_positions[node], expected[node]) << node;
    EXPECT_EQ(glm::dvec3(block[3 * node], block[3 * node + 1], block[3 * node + 2]), expected[node]) << node;
  }
}

TEST(PositionRule, PerJointIsNoOtherThanReplacingWhereNoJointRests) {
  const BvhClip clip = read_or_fail(two_positions("0 0 0", "0 10 0", "5 6 7 0.5 10.5 0"));
  EXPECT_FALSE(has_joints_that_add(clip.skeleton));
}

TEST(PositionRule, WithoutFramesTheDefaultHolds) {
  EXPECT_EQ(read_or_fail(kOneJoint).position_rule, PositionRule::Replace);
}

}  // namespace
}  // namespace marey
