// Quirks of hierarchies beyond the rows of ../shared/bvh-in-the-wild.md, which wild_*_test.cpp follows.
#include <gtest/gtest.h>

#include <string>

#include "tests/core/bvh/bvh_texts.h"

namespace marey {
namespace {

using namespace test;
using Code = DiagnosticCode;

TEST(HierarchyQuirk, SoundFileHasNoFindings) {
  const BvhClip clip = read_or_fail(file_with_lines(kChild, 9));
  EXPECT_TRUE(clip.diagnostics.empty()) << listing(clip);
  EXPECT_EQ(clip.skeleton.joint_count(), 2);
  EXPECT_EQ(clip.skeleton.node_count(), 3);
  EXPECT_EQ(clip.skeleton.offset(1), glm::dvec3(0, 5, 0));
  EXPECT_EQ(clip.motion.sample(8, 0), 9.0);
}

TEST(HierarchyQuirk, BraceOnTheLineOfTheName) {
  const std::string text = replaced(file_with_lines(kChild, 9), "\n  {", " {");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.skeleton.name(1), "Chest");
  EXPECT_TRUE(clip.diagnostics.empty()) << listing(clip);
  EXPECT_EQ(written(clip), text);
}

TEST(HierarchyQuirk, EverythingOnOneLine) {
  const BvhClip clip = read_or_fail("HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 1 Zrotation JOINT b { OFFSET 1 0 0 CHANNELS 1 "
                                    "Yrotation End Site { OFFSET 0 1 0 } } } MOTION Frames: 2 Frame Time: 0.1 1 2 3 4");
  EXPECT_EQ(rows_of(clip), (Rows{{1, 2}, {3, 4}}));
  EXPECT_TRUE(clip.diagnostics.empty()) << listing(clip);
}

TEST(HierarchyQuirk, ChannelsBeforeOffset) {
  const std::string text = replaced(file_with_lines(kChild, 9), "    OFFSET 0 5 0\n    CHANNELS 3 Zrotation Xrotation Yrotation\n",
                                    "    CHANNELS 3 Zrotation Xrotation Yrotation\n    OFFSET 0 5 0\n");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.skeleton.offset(1), glm::dvec3(0, 5, 0));
  EXPECT_TRUE(clip.diagnostics.empty()) << listing(clip);
  EXPECT_EQ(written(clip), text);
}

TEST(HierarchyQuirk, MissingOffsetOrChannels) {
  const BvhClip clip = read_or_fail(file_with_lines("  JOINT a\n  {\n    CHANNELS 1 Zrotation\n    JOINT b\n    {\n      OFFSET 0 1 0\n    }\n  }\n", 7));
  EXPECT_EQ(clip.skeleton.offset(1), glm::dvec3(0, 0, 0));
  EXPECT_EQ(clip.skeleton.channel_count(2), 0);
  expect_finding(clip, Code::MissingOffset, {6, 3});
  expect_finding(clip, Code::MissingChannels, {9, 5});
  expect_round_trip(clip.skeleton, clip.motion, clip.style);
}

TEST(HierarchyQuirk, MissingOpeningBrace) {
  const BvhClip clip = read_or_fail(replaced(file_with_lines(kChild, 9), "  JOINT Chest\n  {\n", "  JOINT Chest\n"));
  EXPECT_EQ(clip.skeleton.joint_count(), 2);
  EXPECT_EQ(clip.skeleton.channel_count(1), 3);
  expect_finding(clip, Code::MissingOpeningBrace, {7, 5});
  EXPECT_FALSE(clip.diagnostics.contains(Code::SurplusClosingBrace));
}

TEST(HierarchyQuirk, MissingClosingBrace) {
  const std::string text = replaced(file_with_lines(kChild, 9), "}\nMOTION", "MOTION");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.skeleton.joint_count(), 2);
  EXPECT_EQ(clip.motion.frame_count(), 1);
  expect_finding(clip, Code::MissingClosingBrace, {15, 1});
}

TEST(HierarchyQuirk, ChannelCountThatDoesNotFitTheNames) {
  for (const std::string count : {"2", "9", "999999999999", "-3", "many", ""}) {
    const BvhClip clip = read_or_fail(replaced(file_with_lines(kChild, 9), "CHANNELS 3", "CHANNELS " + count));
    EXPECT_EQ(clip.skeleton.channel_count(1), count == "many" ? 0 : 3) << count;
    EXPECT_TRUE(clip.diagnostics.contains(Code::ChannelCountMismatch)) << count << listing(clip);
  }
}

TEST(HierarchyQuirk, RepeatedChannel) {
  const BvhClip clip = read_or_fail(replaced(file_with_lines(kChild, 9), "3 Zrotation Xrotation Yrotation", "3 Zrotation Xrotation Zrotation"));
  expect_finding(clip, Code::RepeatedChannel, {6, 3});
  expect_no_warnings(clip);
}

TEST(HierarchyQuirk, EndSiteWithChannels) {
  const BvhClip clip = read_or_fail(replaced(file_with_lines(kChild, 12), "      OFFSET 0 6 0\n", "      OFFSET 0 6 0\n      CHANNELS 3 Zrotation Xrotation Yrotation\n"));
  EXPECT_EQ(clip.skeleton.joint_count(), 3);
  EXPECT_EQ(clip.skeleton.name(2), "End Site");
  expect_finding(clip, Code::EndSiteWithChannels, {10, 5});
}

TEST(HierarchyQuirk, JointOutsideOfAnyRoot) {
  const BvhClip clip = read_or_fail("HIERARCHY\nJOINT a\n{\n OFFSET 0 0 0\n CHANNELS 1 Zrotation\n End Site\n {\n OFFSET 0 1 0\n }\n}\nMOTION\nFrames: 1\nFrame Time: 1\n5\n");
  EXPECT_EQ(clip.skeleton.parent(0), kNoParent);
  expect_finding(clip, Code::JointOutsideRoot, {2, 1});
}

TEST(HierarchyQuirk, MissingNames) {
  const BvhClip clip = read_or_fail(replaced(file_with_lines(kChild, 9), "JOINT Chest", "JOINT"));
  EXPECT_EQ(clip.skeleton.name(1), "");
  expect_finding(clip, Code::MissingName, {6, 3});
  EXPECT_EQ(read_or_fail(replaced(file_with_lines(kChild, 9), "JOINT Chest", "JOINT\n  Chest")).skeleton.name(1), "Chest");
}

TEST(HierarchyQuirk, MissingHierarchyKeyword) {
  const BvhClip clip = read_or_fail(replaced(file_with_lines(kChild, 9), "HIERARCHY\n", ""));
  EXPECT_EQ(clip.skeleton.joint_count(), 2);
  expect_finding(clip, Code::MissingHierarchyKeyword, {1, 1});
  EXPECT_EQ(written(clip).substr(0, 9), "HIERARCHY");
}

TEST(HierarchyQuirk, TextBeforeTheHierarchy) {
  const BvhClip clip = read_or_fail("made by hand\n" + file_with_lines(kChild, 9));
  EXPECT_EQ(clip.skeleton.joint_count(), 2);
  expect_finding(clip, Code::UnexpectedToken, {1, 1});
}

TEST(HierarchyQuirk, BadNumbersInOffset) {
  const BvhClip clip = read_or_fail(replaced(file_with_lines(kChild, 9), "OFFSET 0 5 0", "OFFSET nan five 0.5-3.25"));
  EXPECT_EQ(clip.skeleton.node(1).offset.x, 0.0);
  expect_finding(clip, Code::NotFinite, {8, 12});
  expect_finding(clip, Code::BadNumber, {8, 16});
  expect_finding(clip, Code::NumbersRunTogether, {8, 24});
  expect_finding(clip, Code::OffsetValueCount, {8, 5});
}

TEST(HierarchyQuirk, DecimalCommasInOffset) {
  const BvhClip clip = read_or_fail(replaced(file_with_lines(kChild, 9), "OFFSET 0 5 0", "OFFSET 0,0 5,25 -1,5"));
  EXPECT_EQ(clip.skeleton.offset(1), glm::dvec3(0, 5.25, -1.5));
  expect_finding(clip, Code::DecimalComma, {8, 12}, 3);
}

}  // namespace
}  // namespace marey
