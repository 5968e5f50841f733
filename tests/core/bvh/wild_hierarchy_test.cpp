// One test per row of ../shared/bvh-in-the-wild.md that is about the hierarchy, named after it.
#include <gtest/gtest.h>

#include <string>

#include "tests/core/bvh/bvh_texts.h"

namespace marey {
namespace {

using namespace test;
using Code = DiagnosticCode;

TEST(WildRow02, TabsInHierarchy) {
  const std::string text = replaced(file_with_lines(kChild, 9), "  ", "\t");
  expect_no_warnings(read_or_fail(text));
  EXPECT_EQ(written(read_or_fail(text)), text);
}

TEST(WildRow03, TrailingBlanksOnHeaderLines) {
  const std::string text = replaced(file_with_lines(kChild, 9), "\n", " \t\n");
  const BvhClip clip = read_or_fail(text);
  expect_no_warnings(clip);
  EXPECT_EQ(clip.skeleton.name(1), "Chest");
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow04, CarriageReturnsOfEachKind) {
  const std::string text = file_with_lines(kChild, 9);
  for (const std::string& variant :
       {replaced(text, "\n", "\r\n"), replaced(text, "\n", "\r"), replaced(text, "{\n", "{\r\n")}) {
    const BvhClip clip = read_or_fail(variant);
    expect_no_warnings(clip);
    EXPECT_EQ(clip.skeleton, read_or_fail(text).skeleton);
    EXPECT_EQ(rows_of(clip), rows_of(read_or_fail(text)));
    EXPECT_EQ(written(clip), variant);
  }
}

TEST(WildRow10, SomeJointsWithSixChannels) {
  const std::string lines = replaced(std::string(kChild), "3 Zrotation", "6 Xposition Yposition Zposition Zrotation");
  const BvhClip clip = read_or_fail(file_with_lines(lines, 12));
  EXPECT_EQ(clip.skeleton.channel_count(1), 6);
  expect_no_warnings(clip);
}

TEST(WildRow11, RotationOrderVariesWithinAFile) {
  const BvhClip clip = read_or_fail(file_with_lines(replaced(std::string(kChild), "Zrotation Xrotation", "Xrotation Zrotation"), 9));
  EXPECT_EQ(euler_order_label(clip.skeleton, 0), "ZXY");
  EXPECT_EQ(euler_order_label(clip.skeleton, 1), "XZY");
}

TEST(WildRow12, AnyOrderOfPositionsAndRotations) {
  const BvhClip clip = read_or_fail(replaced(file_with_lines("", 6), "6 Xposition Yposition Zposition Zrotation Xrotation Yrotation",
                                             "6 Zrotation Zposition Xrotation Xposition Yrotation Yposition"));
  EXPECT_EQ(clip.skeleton.channel(1).kind, ChannelKind::Zposition);
  EXPECT_EQ(clip.skeleton.channel(5).kind, ChannelKind::Yposition);
  EXPECT_FALSE(clip.diagnostics.contains(Code::UnexpectedToken));
}

TEST(WildRow13, ChannelCase) {
  const std::string text = replaced(file_with_lines(kChild, 9), "Xposition", "XPosition");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.skeleton.channel(0).kind, ChannelKind::Xposition);
  expect_finding(clip, Code::ChannelCase, {5, 14});
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow14, KeywordCase) {
  const std::string text = replaced(replaced(file_with_lines(kChild, 9), "End Site", "End site"), "JOINT", "joint");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.skeleton.node_count(), 3);
  expect_finding(clip, Code::KeywordCase, {6, 3}, 2);
  EXPECT_EQ(written(clip), text);
  std::string all_lower = file_with_lines(kChild, 9);
  for (char& c : all_lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  EXPECT_EQ(rows_of(read_or_fail(all_lower)), rows_of(clip));
}

TEST(WildRow15, AnyNumberOfChannels) {
  const std::string lines =
      "  JOINT none { OFFSET 0 1 0 CHANNELS 0\n JOINT one { OFFSET 0 1 0 CHANNELS 1 Zrotation End Site { OFFSET 0 1 0 } } }\n";
  const BvhClip clip = read_or_fail(file_with_lines(lines, 7));
  EXPECT_EQ(clip.skeleton.channel_count(1), 0);
  EXPECT_EQ(clip.skeleton.channel_count(2), 1);
  expect_no_warnings(clip);
  const BvhClip bare = read_or_fail("HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 0 End Site { OFFSET 0 1 0 } } MOTION Frames: 7 Frame Time: 0.1\n");
  EXPECT_EQ(bare.motion.frame_count(), 7);
}

TEST(WildRow16, ScaleAndUnknownChannels) {
  const std::string lines = replaced(std::string(kChild), "3 Zrotation", "5 Xscale Grip Zrotation");
  const BvhClip clip = read_or_fail(file_with_lines(lines, 11));
  EXPECT_EQ(clip.skeleton.channel(6).kind, ChannelKind::Xscale);
  EXPECT_EQ(clip.skeleton.channel(7).kind, ChannelKind::Other);
  EXPECT_EQ(clip.skeleton.channel(7).other_name, "Grip");
  EXPECT_EQ(clip.motion.sample(7, 0), 8.0);
  expect_finding(clip, Code::UnknownChannel, {9, 23});
  EXPECT_EQ(written(clip), file_with_lines(lines, 11));
}

TEST(WildRow17, LeafWithoutEndSite) {
  const std::string text = file_with_lines("  JOINT L_Wrist_End\n  {\n    OFFSET 0 5 0\n    CHANNELS 0\n  }\n", 6);
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.skeleton.node_count(), 2);
  expect_finding(clip, Code::LeafWithoutEndSite, {6, 3});
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow18, EndSiteBesideChildrenAndSeveral) {
  const std::string ends = "  End Site\n  {\n    OFFSET 1 0 0\n  }\n";
  const std::string text = file_with_lines(ends + std::string(kChild) + ends, 9);
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.skeleton.node_count(), 5);
  expect_finding(clip, Code::EndSiteBesideChildren, {2, 1});
  expect_finding(clip, Code::SeveralEndSites, {2, 1});
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow19, EndSiteWithAName) {
  for (const auto& [spelling, name] : {std::pair("End Site4", "4"), std::pair("End Site foo", "foo")}) {
    const std::string text = replaced(file_with_lines(kChild, 9), "End Site", spelling);
    const BvhClip clip = read_or_fail(text);
    EXPECT_EQ(clip.skeleton.node(2).name, name);
    EXPECT_TRUE(clip.skeleton.node(2).is_end_site);
    expect_finding(clip, Code::NamedEndSite, {10, 5});
    EXPECT_EQ(written(clip), text);
  }
}

TEST(WildRow20, NamesAreTheRestOfTheLine) {
  for (const std::string name : {"mixamorig:Hips", "spine.001", "Bip01 Neck", "L Wrist # left", "a//b", "骨|(1)", "Pesco\xe7o",
                                 "End", "JOINT", "ROOT OFFSET"}) {
    const std::string text = replaced(file_with_lines(kChild, 9), "Chest", name);
    const BvhClip clip = read_or_fail(text);
    EXPECT_EQ(clip.skeleton.node(1).name_bytes, name);
    EXPECT_EQ(written(clip), text);
  }
  const std::string with_blank = replaced(file_with_lines(kChild, 9), "Chest", "Chest ");
  EXPECT_EQ(read_or_fail(with_blank).skeleton.name(1), "Chest");
  EXPECT_EQ(written(read_or_fail(with_blank)), with_blank);
}

TEST(WildRow21, DuplicateNames) {
  const std::string text = replaced(file_with_lines(kChild, 9), "Chest", "Hips");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.skeleton.joint_count(), 2);
  expect_finding(clip, Code::DuplicateName, {6, 3});
}

TEST(WildRow22, SeveralRoots) {
  const std::string second = "}\nROOT Prop\n{\n  OFFSET 1 2 3\n  CHANNELS 3 Xposition Yposition Zposition\n  End Site\n  {\n    OFFSET 0 1 0\n  }\n";
  const std::string text = file_with_lines(std::string(kChild) + second, 12);
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.skeleton.parent(2), kNoParent);
  expect_finding(clip, Code::SeveralRoots);
  expect_no_warnings(clip);
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow23, ExponentsInOffset) {
  const BvhClip clip = read_or_fail(replaced(file_with_lines(kChild, 9), "OFFSET 0 5 0", "OFFSET 1.2e-15 5E0 -3.5e-007"));
  EXPECT_EQ(clip.skeleton.offset(1), glm::dvec3(1.2e-15, 5.0, -3.5e-7));
}

TEST(WildRow32, BlankLinesInHierarchy) {
  const std::string text = replaced(file_with_lines(kChild, 9), "\n", "\n\n");
  const BvhClip clip = read_or_fail(text);
  expect_no_warnings(clip);
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow35, Comments) {
  const std::string text = "# recorded in May\n" + replaced(file_with_lines(kChild, 9), "    CHANNELS", "// arms\n    CHANNELS");
  const BvhClip clip = read_or_fail(text);
  EXPECT_EQ(clip.skeleton.joint_count(), 2);
  expect_finding(clip, Code::Comment, {1, 1}, 2);
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow38, ZeroLengthBones) {
  const BvhClip clip = read_or_fail(replaced(file_with_lines(kChild, 9), "OFFSET 0 5 0", "OFFSET 0 0 0"));
  expect_finding(clip, Code::ZeroLengthBone, {6, 3});
}

TEST(WildRow42, ByteOrderMark) {
  const std::string text = "\xef\xbb\xbf" + file_with_lines(kChild, 9);
  const BvhClip clip = read_or_fail(text);
  expect_finding(clip, Code::ByteOrderMark, {1, 1});
  EXPECT_EQ(written(clip), text);
}

TEST(WildRow45, TwoOffsetAndTwoChannelsLines) {
  const std::string lines = replaced(std::string(kChild), "    End Site",
                                     "    OFFSET 0 7 0\n    CHANNELS 2 Xscale Yscale\n    End Site");
  const BvhClip clip = read_or_fail(file_with_lines(lines, 11));
  EXPECT_EQ(clip.skeleton.channel_count(1), 5);
  EXPECT_EQ(clip.skeleton.offset(1), glm::dvec3(0, 7, 0));
  expect_finding(clip, Code::RepeatedOffset, {10, 5});
  expect_finding(clip, Code::RepeatedChannelsLine, {11, 5});
  expect_round_trip(clip.skeleton, clip.motion, clip.style);
}

TEST(WildRow46, OffsetAsAList) {
  const BvhClip clip = read_or_fail(replaced(file_with_lines(kChild, 9), "OFFSET 0 5 0", "OFFSET [0, 5, 0]"));
  EXPECT_EQ(clip.skeleton.offset(1), glm::dvec3(0, 5, 0));
  EXPECT_EQ(clip.skeleton.channel_count(1), 3);
  expect_finding(clip, Code::OffsetBracketed, {8, 12}, 4);
  EXPECT_NE(written(clip).find("OFFSET 0 5 0"), std::string::npos) << written(clip);
}

TEST(WildRow47, StrayWordsAndSurplusBraces) {
  const BvhClip clip = read_or_fail(replaced(file_with_lines(std::string(kChild) + "} q\n", 9), "    End", "    x\n    End"));
  EXPECT_EQ(clip.skeleton.joint_count(), 2);
  expect_finding(clip, Code::UnexpectedToken, {10, 5});
  expect_finding(clip, Code::TextAfterHierarchyEnd, {16, 3});
  expect_finding(clip, Code::SurplusClosingBrace, {17, 1});
  expect_round_trip(clip.skeleton, clip.motion, clip.style);
}

TEST(WildRow49, CutInTheMiddleOfTheHierarchy) {
  const std::string text = file_with_lines(kChild, 9);
  const BvhClip clip = read_or_fail(std::string_view(text).substr(0, text.find("    End Site")));
  EXPECT_EQ(clip.skeleton.joint_count(), 2);
  EXPECT_EQ(clip.motion.frame_count(), 0);
  expect_finding(clip, Code::UnexpectedEnd);
  expect_finding(clip, Code::MissingMotion);
}

}  // namespace
}  // namespace marey
