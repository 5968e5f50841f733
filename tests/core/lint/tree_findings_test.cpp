#include <gtest/gtest.h>

#include "tests/core/lint/lint_clips.h"

namespace marey {
namespace {

using namespace test;
using figures::channels;
using figures::JointPlan;
using Kind = FindingKind;

const std::vector<ChannelKind> kRoot = channels("xyzZXY");
const std::vector<ChannelKind> kTurn = channels("ZXY");
const std::vector<glm::dvec3> kEnd = {{0.0, 1.0, 0.0}};
const glm::dvec3 kUp(0.0, 1.0, 0.0);

LintReport lint_joints(const std::vector<JointPlan>& joints) { return lint_clip(make_still(joints)); }

/// A root with two limbs of these names.
LintReport lint_names(const std::string& a, const std::string& b) {
  return lint_joints({{"Hips", kNoParent, {}, kRoot, {}}, {a, 0, kUp, kTurn, kEnd}, {b, 0, kUp, kTurn, kEnd}});
}

/// A root with a limb of these channels.
LintReport lint_channels(const std::string& root, const std::string& limb) {
  return lint_joints({{"Hips", kNoParent, {}, channels(root), {}}, {"Arm", 0, kUp, channels(limb), kEnd}});
}

TEST(NameFindings, NothingAboutPlainNames) {
  EXPECT_EQ(kinds_of(lint_names("LeftArm", "mixamorig:RightArm.001_end")), "");
}

TEST(NameFindings, DuplicatesNameTheJointsOnce) {
  const Finding finding = the_finding(lint_names("Arm", "Arm"), Kind::DuplicateName);
  EXPECT_EQ(finding.joint, 1);
  EXPECT_EQ(finding.count, 2);
  EXPECT_EQ(finding.frames, std::nullopt);
  EXPECT_EQ(finding.message, "'Arm' (2 joints) is the name of more than one joint.");
}

TEST(NameFindings, EmptyNamesAreNoDuplicates) {
  const LintReport report = lint_names("", "");
  EXPECT_EQ(kinds_of(report), "empty_name");
  EXPECT_EQ(report.findings[0].message, "2 joints are without a name.");
}

TEST(NameFindings, BlanksAndLettersBeyondAscii) {
  EXPECT_EQ(kinds_of(lint_names("Left Arm", "H\xc3\xbc" "fte")), "name_with_blank name_not_ascii");
  EXPECT_EQ(the_finding(lint_names("Left Arm", "Leg"), Kind::NameWithBlank).message, "1 name with a blank in it: 'Left Arm'.");
}

TEST(NameFindings, NamesThatDifferInCaseOnly) {
  const LintReport report = lint_names("Arm", "ARM");
  EXPECT_EQ(kinds_of(report), "name_differs_in_case");
  EXPECT_EQ(report.findings[0].joint, 2);
}

TEST(SkeletonFindings, NothingAboutAPlainTree) { EXPECT_EQ(kinds_of(lint_clip(make_moving_walker(0))), ""); }

TEST(SkeletonFindings, SeveralRoots) {
  const LintReport report = lint_joints({{"A", kNoParent, {}, kRoot, kEnd}, {"B", kNoParent, {}, kRoot, kEnd}});
  EXPECT_EQ(kinds_of(report), "several_roots");
  EXPECT_EQ(report.findings[0].message, "2 roots in one file: 'A' and 'B'.");
}

TEST(SkeletonFindings, ZeroLengthBonesButNoRootAtTheOrigin) {
  const LintReport report = lint_joints({{"Hips", kNoParent, {}, kRoot, {}}, {"Back", 0, {}, kTurn, kEnd}});
  EXPECT_EQ(kinds_of(report), "zero_length_bone");
  EXPECT_EQ(report.findings[0].joint, 1);
}

TEST(SkeletonFindings, LeavesWithoutEndSite) {
  const LintReport report = lint_joints({{"Hips", kNoParent, {}, kRoot, {}}, {"Arm", 0, kUp, kTurn, {}}});
  EXPECT_EQ(kinds_of(report), "leaf_without_end_site");
  EXPECT_EQ(report.findings[0].joint, 1);
}

TEST(SkeletonFindings, SetsOfChannels) {
  EXPECT_EQ(kinds_of(lint_channels("xyzZXY", "ZXY")), "");
  EXPECT_EQ(kinds_of(lint_channels("ZXY", "ZXY")), "");
  EXPECT_EQ(kinds_of(lint_channels("xyzZXY", "")), "joint_without_channels");
  EXPECT_EQ(kinds_of(lint_channels("xyzZXY", "X")), "single_channel_joint");
  EXPECT_EQ(kinds_of(lint_channels("xyzZXY", "xyzZXY")), "position_below_root");
}

TEST(SkeletonFindings, OrdersOfChannels) {
  EXPECT_EQ(kinds_of(lint_channels("xyzZXY", "ZYX")), "mixed_rotation_orders");
  EXPECT_EQ(kinds_of(lint_channels("xyzXZY", "XZY")), "rare_rotation_order");
  EXPECT_EQ(kinds_of(lint_channels("ZXYxyz", "ZXY")), "unusual_channel_order");
  EXPECT_EQ(kinds_of(lint_channels("zxyZXY", "ZXY")), "unusual_channel_order");
  EXPECT_EQ(the_finding(lint_channels("xyzZXY", "ZYX"), Kind::MixedRotationOrders).message,
            "The joints rotate in different orders: ZXY (1 joint) and ZYX (1 joint).");
}

TEST(SkeletonFindings, ManyJointsAreOneFinding) {
  std::vector<JointPlan> joints = {{"Hips", kNoParent, {}, kRoot, {}}};
  for (int i = 0; i < 20; ++i) joints.push_back({"Toe" + std::to_string(i), 0, kUp, kRoot, kEnd});
  const Finding finding = the_finding(lint_joints(joints), Kind::PositionBelowRoot);
  EXPECT_EQ(finding.count, 20);
  EXPECT_EQ(finding.message, "20 joints below the root with position channels: 'Toe0', 'Toe1', 'Toe2' and 17 more.");
}

}  // namespace
}  // namespace marey
