// One test per row of ../shared/bvh-in-the-wild.md that is about conventions and receivers rather than spelling, and the
// check that every row has a test.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/lint/lint.h"
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

void expect_rule(const std::string& text, PositionRule rule) {
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.position_rule, rule) << text << listing(clip);
  EXPECT_EQ(written(clip), text);
}

bool lint_finds(const BvhClip& file, FindingKind kind) {
  const LintReport report = lint_clip(Clip{file.skeleton, file.motion, {}});
  return std::any_of(report.findings.begin(), report.findings.end(), [&](const Finding& f) { return f.kind == kind; });
}

TEST(WildRow07, PositionChannelsOnEveryJoint) {
  const std::string text = two_positions("0 0 0", "0 10 0", "5 6 7 0.5 10.5 0");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip), (Rows{{5, 6, 7, 0.5, 10.5, 0}}));
  EXPECT_EQ(clip.skeleton.channel(3).kind, ChannelKind::Xposition);
  EXPECT_EQ(written(clip), text);
  EXPECT_TRUE(lint_finds(clip, FindingKind::PositionBelowRoot));
}

TEST(WildRow08, PositionsReplaceTheOffsetOrAddToIt) {
  expect_rule(two_positions("0 0 0", "0 10 0", "5 6 7 0.5 10.5 0"), PositionRule::Replace);
  expect_rule(two_positions("0 0 0", "0 10 0", "5 6 7 0 0 0"), PositionRule::Add);
  expect_rule(two_positions("0 0 0", "0 0 0", "5 6 7 1 2 3"), PositionRule::Replace);
  expect_finding(read_or_fail(two_positions("0 0 0", "0 10 0", "5 6 7 0.5 10.5 0")), Code::PositionsReplaceOffset, {6, 1});
  expect_finding(read_or_fail(two_positions("0 0 0", "0 10 0", "5 6 7 0 0 0")), Code::PositionsAddToOffset, {6, 1});
}

TEST(WildRow09, RootOffsetBesideRootPosition) {
  for (const std::string y : {"90", "91"}) {
    const std::string text = two_positions("0 90 0", "0 0 0", "0 " + y + " 0 0 0 0");
    expect_rule(text, PositionRule::Replace);
    expect_finding(read_or_fail(text), Code::PositionsReplaceOffset, {2, 1});
  }
}

TEST(WildRow37, FirstFrameAsAReferencePose) {
  std::string rows = "0 0 0\n";
  for (int i = 0; i < 20; ++i) rows += "40." + std::to_string(i) + " -35 20\n";
  const std::string text = one_joint_file("21", rows);
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(rows_of(clip).front(), (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(clip.motion.frame_count(), 21);
  EXPECT_EQ(written(clip), text);
  EXPECT_TRUE(lint_finds(clip, FindingKind::ReferencePose));
}

TEST(WildRow39, UnitsAreGuessedFromTheStatureAndTheNumbersStay) {
  const auto figure = [](const std::string& height) {
    return replaced(replaced(file_with_lines(kChild, 9), "0 5 0", "0 " + height + " 0"), "0 6 0", "0 " + height + " 0");
  };
  EXPECT_EQ(guess_metres_per_unit(read_or_fail(figure("0.85")).skeleton), 1.0);
  EXPECT_EQ(guess_metres_per_unit(read_or_fail(figure("85")).skeleton), 0.01);
  EXPECT_EQ(guess_metres_per_unit(read_or_fail(figure("850")).skeleton), 0.001);
  EXPECT_EQ(guess_metres_per_unit(read_or_fail(figure("33.5")).skeleton), 0.0254);
  for (const std::string height : {"0.85", "85", "850", "33.5"}) {
    EXPECT_EQ(written(read_or_fail(figure(height))), figure(height));
  }
}

TEST(WildRow40, LeafJointsStayJointsAndFlipsAreFound) {
  const std::string leaf = "  JOINT Hand\n  {\n    OFFSET 0 5 0\n    CHANNELS 3 Zrotation Xrotation Yrotation\n  }\n";
  BvhClip clip = read_or_fail(file_with_lines(leaf, 9));
  clip.skeleton.set_offset(0, {0, 1, 0});
  clip.motion.channel_samples(8)[0] = -4.5;
  const BvhClip again = read_or_fail(written(clip));
  EXPECT_EQ(again.skeleton, clip.skeleton);
  EXPECT_FALSE(again.skeleton.node(1).is_end_site);
  EXPECT_EQ(rows_of(again), rows_of(clip));
  std::string rows;
  for (int i = 0; i < 40; ++i) rows += std::to_string((170 + i + 180) % 360 - 180) + " 0 0\n";
  EXPECT_TRUE(lint_finds(read_or_fail(one_joint_file("40", rows)), FindingKind::AngleWrap));
}

TEST(WildRow41, OrdersThatReceiversRefuseAreFound) {
  const std::string mixed = replaced(std::string(kChild), "Zrotation Xrotation Yrotation", "Xrotation Zrotation Yrotation");
  const BvhClip clip = read_or_fail(file_with_lines(mixed, 9));
  EXPECT_TRUE(lint_finds(clip, FindingKind::MixedRotationOrders));
  EXPECT_TRUE(lint_finds(clip, FindingKind::RareRotationOrder));
  EXPECT_FALSE(lint_finds(read_or_fail(file_with_lines(kChild, 9)), FindingKind::MixedRotationOrders));
}

TEST(WildRow48, NamesThatEndInABlankHoldAHashOrAreLatin1) {
  for (const auto& [written_name, name] :
       {std::pair("Chest ", "Chest"), std::pair("L Wrist # left", "L Wrist # left"), std::pair("Pesco\xe7o", "Pescoço")}) {
    const std::string text = replaced(file_with_lines(kChild, 9), "Chest", written_name);
    const BvhClip clip = read_or_fail(text);
    EXPECT_EQ(clip.skeleton.name(1), name);
    EXPECT_FALSE(clip.diagnostics.contains(Code::Comment));
    EXPECT_EQ(written(clip), text);
  }
}

TEST(WildRow51, PositionsOnlyAndInterleavedChannels) {
  const std::string channels = "CHANNELS 6 Zrotation Xposition Xrotation Yposition Yrotation Zposition";
  const std::string lines = replaced(std::string(kChild), "CHANNELS 3 Zrotation Xrotation Yrotation",
                                     "CHANNELS 3 Xposition Yposition Zposition");
  const std::string text = replaced(file_with_lines(lines, 9),
                                    "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation", channels);
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.skeleton.channel(1).kind, ChannelKind::Xposition);
  EXPECT_EQ(clip.skeleton.channel(4).kind, ChannelKind::Yrotation);
  EXPECT_EQ(clip.skeleton.channel(6).kind, ChannelKind::Xposition);
  EXPECT_EQ(rows_of(clip), (Rows{{1, 2, 3, 4, 5, 6, 7, 8, 9}}));
  expect_no_warnings(clip);
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow53, TabsAndAFewLineFeedsAmongCarriageReturns) {
  std::string text = replaced(replaced(file_with_lines(kChild, 9), "  ", "\t"), "\n", "\r\n");
  text = replaced(replaced(text, "End Site\r\n", "End Site\n"), "MOTION\r\n", "MOTION\n");
  const BvhClip clip = read_or_fail(text);
  expect_no_warnings(clip);
  EXPECT_EQ(clip.skeleton, read_or_fail(file_with_lines(kChild, 9)).skeleton);
  EXPECT_EQ(written(clip), text);
}

TEST(WildRows, HaveATestEach) {
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  std::set<std::string> suites;
  for (int i = 0; i < all.total_test_suite_count(); ++i) suites.insert(all.GetTestSuite(i)->name());
  for (int row = 1; row <= 53; ++row) {
    const std::string name = std::string("WildRow") + (row < 10 ? "0" : "") + std::to_string(row);
    EXPECT_TRUE(suites.contains(name)) << name;
  }
}

}  // namespace
}  // namespace marey
