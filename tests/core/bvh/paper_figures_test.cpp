// The figures of the paper on BVH files in biomechanics, as printed.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "tests/core/bvh/bvh_texts.h"
#include "tests/support/files.h"

namespace marey {
namespace {

using namespace test;
using Code = DiagnosticCode;

std::string data_file(const std::string& name) { return read_repository_file("tests/core/bvh/data/" + name); }

struct ExpectedFinding {
  Code code;
  TextPlace place;
  std::string message;
};

const std::vector<ExpectedFinding>& repairs_of_figure_3() {
  static const std::vector<ExpectedFinding> kRepairs = {
      {Code::OffsetValueCount, {8, 5}, "The OFFSET of 'Body' has 4 values; it was read as 0.0 10.0 0.0."},
      {Code::JoinedTree, {10, 3},
       "'Body' is closed before it has a child, and a later '}' is left over; 'Legs' was nested in it."},
      {Code::OffsetValueCount, {13, 5}, "The OFFSET of 'Legs' has 4 values; it was read as 0.0 12.0 0.0."},
      {Code::JoinedTree, {15, 3},
       "'Legs' is closed before it has a child, and a later '}' is left over; End Site was nested in it."},
      {Code::OffsetValueCount, {18, 5}, "The OFFSET of the end site has 4 values; it was read as 0.0 16.0 0.0."}};
  return kRepairs;
}

TEST(PaperFigures, GymnastAsPrintedNamesEachRepairAndItsPlace) {
  const BvhClip clip = read_or_fail(data_file("gymnast_as_printed.bvh"));
  const auto& found = clip.diagnostics.list();
  ASSERT_EQ(found.size(), repairs_of_figure_3().size()) << listing(clip);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].code, repairs_of_figure_3()[i].code);
    EXPECT_EQ(found[i].place, repairs_of_figure_3()[i].place);
    EXPECT_EQ(found[i].message, repairs_of_figure_3()[i].message);
    EXPECT_EQ(found[i].severity, Severity::Warning);
  }
}

TEST(PaperFigures, GymnastAsPrintedBecomesTheCorrectedFile) {
  const BvhClip clip = read_or_fail(data_file("gymnast_as_printed.bvh"));
  EXPECT_EQ(written(clip), data_file("gymnast_corrected.bvh"));
  const BvhClip corrected = read_or_fail(data_file("gymnast_corrected.bvh"));
  EXPECT_TRUE(corrected.diagnostics.empty()) << listing(corrected);
  EXPECT_EQ(clip.skeleton, corrected.skeleton);
  EXPECT_TRUE(same_numbers(clip.skeleton, clip.motion, corrected.skeleton, corrected.motion));
}

TEST(PaperFigures, StrictReadingRefusesTheGymnastWithThePlaceAndReasonOfTheFirstRepair) {
  const Error error = refusal_of(data_file("gymnast_as_printed.bvh"), {.strict = true, .limits = {}});
  EXPECT_EQ(error.code, repairs_of_figure_3()[0].code);
  EXPECT_EQ(error.place, repairs_of_figure_3()[0].place);
  EXPECT_EQ(error.message, repairs_of_figure_3()[0].message);
  EXPECT_TRUE(read_bvh(data_file("gymnast_corrected.bvh"), {.strict = true, .limits = {}}));
}

TEST(PaperFigures, PartsOfACaptureOpen) {
  const BvhClip clip = read_or_fail(data_file("spine_figures_1_and_2.bvh"));
  ASSERT_EQ(clip.skeleton.joint_count(), 6);
  EXPECT_EQ(clip.skeleton.name(5), "Head");
  EXPECT_EQ(clip.skeleton.parent(5), 4);
  EXPECT_EQ(clip.skeleton.offset(5), glm::dvec3(0.0));
  EXPECT_EQ(clip.skeleton.channel_count(5), 0);
  EXPECT_EQ(clip.skeleton.channel_count(), 18);
  expect_finding(clip, Code::JointWithoutBlock, {22, 11});
  EXPECT_EQ(clip.motion.frame_count(), 7);
  EXPECT_EQ(clip.motion.sample(1, 0), 93.042686);
  EXPECT_EQ(clip.motion.sample(10, 6), 4.9251);
  EXPECT_EQ(clip.motion.sample(11, 6), 0.0);
  expect_finding(clip, Code::RowLength, {31, 1}, 7);
  expect_finding(clip, Code::FrameCountMismatch, {29, 9});
  EXPECT_NE(written(clip).find("-0.000005 10.181586 0.131518"), std::string::npos) << "keeps the decimals of the figure";
}

std::string with_offset(const std::string& offset) {
  return "HIERARCHY\nROOT a\n{\n OFFSET 0 0 0\n CHANNELS 3 Zrotation Xrotation Yrotation\n End Site\n {\n  OFFSET " + offset +
         "\n }\n}\nMOTION\nFrames: 2\nFrame Time: 0.1\n";
}

TEST(OffsetRepair, JoinsLostDecimalPoints) {
  const std::vector<std::tuple<std::string, glm::dvec3>> cases = {
      {"0 0 10.0 0.0", {0, 10, 0}},   {"10.5 0 0 0.0", {10.5, 0, 0}}, {"1.0 2.0 3 25", {1, 2, 3.25}},
      {"0 0 0 0 0 0", {0, 0, 0}},     {"-3 5 1.0 2.0", {-3.5, 1, 2}}, {"0 0 10 5 0.0", {0, 10.5, 0}}};
  for (const auto& [text, offset] : cases) {
    const BvhClip clip = read_or_fail(with_offset(text) + "0 0 0\n1 1 1\n");
    EXPECT_EQ(clip.skeleton.node(1).offset, offset) << text;
    EXPECT_TRUE(clip.diagnostics.contains(Code::OffsetValueCount)) << text;
  }
}

TEST(OffsetRepair, DropsASurplusZeroOrTakesTheFirstThree) {
  EXPECT_EQ(read_or_fail(with_offset("0.0 5.0 1.0 2.0") + "0 0 0\n1 1 1\n").skeleton.node(1).offset, glm::dvec3(5, 1, 2));
  EXPECT_EQ(read_or_fail(with_offset("4.0 5.0 1.0 2.0") + "0 0 0\n1 1 1\n").skeleton.node(1).offset, glm::dvec3(4, 5, 1));
  EXPECT_EQ(read_or_fail(with_offset("4.0 5.0") + "0 0 0\n1 1 1\n").skeleton.node(1).offset, glm::dvec3(4, 5, 0));
  EXPECT_EQ(read_or_fail(with_offset("") + "0 0 0\n1 1 1\n").skeleton.node(1).offset, glm::dvec3(0, 0, 0));
}

TEST(OffsetRepair, LetsThePlaneOfTheMotionDecide) {
  // 0.7 5 0, 0 7.5 0 and 0 7 5.0 are all possible; only rotation about one axis tells which.
  const std::string offset = with_offset("0 7 5 0");
  const BvhClip about_z = read_or_fail(offset + "0 0 0\n9 0 0\n");
  EXPECT_EQ(about_z.skeleton.node(1).offset, glm::dvec3(0.7, 5, 0));
  const BvhClip about_x = read_or_fail(offset + "0 0 0\n0 9 0\n");
  EXPECT_EQ(about_x.skeleton.node(1).offset, glm::dvec3(0, 7.5, 0));
  expect_finding(about_x, Code::OffsetValueCount, {8, 3});
}

std::string tree_closed_early(const std::string& between, const std::string& end) {
  const std::string joint = "OFFSET 0 1 0 CHANNELS 1 Zrotation\n";
  return "HIERARCHY\nROOT a\n{\n" + joint + "JOINT b\n{\n" + joint + "}\n" + between + "JOINT c\n{\n" + joint +
         "End Site\n{\nOFFSET 0 1 0\n}\n}\n" + end + "MOTION\nFrames: 1\nFrame Time: 0.1\n1 2 3\n";
}

TEST(NestingRepair, JoinsOnlyWhenABraceIsLeftOver) {
  const BvhClip nested = read_or_fail(tree_closed_early("", "}\n}\n"));
  EXPECT_EQ(nested.skeleton.parent(2), 1);
  expect_finding(nested, Code::JoinedTree, {8, 1});
  const BvhClip siblings = read_or_fail(tree_closed_early("", "}\n"));
  EXPECT_EQ(siblings.skeleton.parent(2), 0);
  EXPECT_FALSE(siblings.diagnostics.contains(Code::JoinedTree));
}

TEST(NestingRepair, LeavesATreeAloneWhoseLeavesHaveNoEndSiteByHabit) {
  const std::string another_leaf = "JOINT d\n{\nOFFSET 0 1 0 CHANNELS 0\n}\n";
  const BvhClip clip = read_or_fail(tree_closed_early(another_leaf, "}\n}\n"));
  EXPECT_EQ(clip.skeleton.parent(2), 0);
  EXPECT_EQ(clip.skeleton.parent(3), 0);
  EXPECT_FALSE(clip.diagnostics.contains(Code::JoinedTree));
  EXPECT_TRUE(clip.diagnostics.contains(Code::SurplusClosingBrace));
}

TEST(NestingRepair, StaysWithinOneRoot) {
  std::string text = tree_closed_early("", "}\nROOT z\n{\nOFFSET 0 0 0\nCHANNELS 0\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n}\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.skeleton.parent(2), 0);
  EXPECT_TRUE(clip.diagnostics.contains(Code::SurplusClosingBrace));
}

}  // namespace
}  // namespace marey
