// What people and programs write behind "Frame Time:" and "Frames:" beside a number.
#include <gtest/gtest.h>

#include <string>

#include "tests/core/bvh/bvh_texts.h"

namespace marey {
namespace {

using namespace test;
using Code = DiagnosticCode;

const char kRows[] = "1 2 3\n4 5 6\n";
const Rows kValues = {{1, 2, 3}, {4, 5, 6}};

BvhClip read_head(const std::string& head) { return read_or_fail(std::string(kOneJoint) + "MOTION\n" + head + kRows); }

BvhClip read_time(const std::string& time) { return read_head("Frames: 2\nFrame Time: " + time + "\n"); }

TEST(FrameTimeText, UnitsAndFractionsAreUnderstoodAndSavedAsSeconds) {
  const std::pair<std::string, double> cases[] = {
      {"0.025s", 0.025}, {"0.025 sec", 0.025}, {"0.025;", 0.025}, {"0.025,", 0.025}, {"0.025f", 0.025},  {"25 ms", 0.025},
      {"25ms", 0.025},   {"1/40", 0.025},      {"40Hz", 0.025},   {"40 fps", 0.025}, {"0.025 seconds", 0.025}};
  for (const auto& [text, seconds] : cases) {
    const BvhClip clip = read_time(text);
    EXPECT_EQ(clip.motion.frame_time_s(), seconds) << text;
    EXPECT_EQ(rows_of(clip), kValues) << text;
    expect_finding(clip, Code::UnexpectedToken, {13, 13});
    EXPECT_NE(written(clip).find("\nFrame Time: 0.025\n1 2 3\n"), std::string::npos) << written(clip);
  }
}

TEST(FrameTimeText, WhatCanHardlyBeMeantIsKeptAndPointedAt) {
  for (const std::string text : {"8.3333", "1e-12"}) {
    const BvhClip clip = read_time(text);
    EXPECT_EQ(clip.motion.frame_time_s(), std::stod(text));
    expect_finding(clip, Code::FrameTimeLooksLikeRate, {13, 13});
    EXPECT_NE(written(clip).find("Frame Time: " + text + "\n"), std::string::npos);
  }
  EXPECT_TRUE(read_time("1.0").diagnostics.list().empty());
  EXPECT_TRUE(read_time("0.0005").diagnostics.list().empty());
}

TEST(FrameTimeText, ASecondFrameLineIsNoFrameTime) {
  for (const std::string line : {"Frame: 7", "Start Frame: 1"}) {
    const BvhClip clip = read_head("Frames: 2\nFrame Time: 0.025\n" + line + "\n");
    EXPECT_EQ(clip.motion.frame_time_s(), 0.025) << line;
    EXPECT_EQ(rows_of(clip), kValues) << line;
    EXPECT_NE(clip.diagnostics.find(Code::UnexpectedToken), nullptr) << line;
  }
  const BvhClip clip = read_head("Frames: 2\nFrame: 0.025\n");
  EXPECT_EQ(clip.motion.frame_time_s(), 0.025);
  expect_finding(clip, Code::UnexpectedToken, {13, 1});
}

TEST(FrameTimeText, CommentsAndLineEndsBeforeTheValueArePassed) {
  for (const std::string head : {"Frames: # so many\n2\nFrame Time: # s\n0.025\n", "Frames: /* n */ 2\nFrame Time /* t */: 0.025\n",
                                 "Frames: 2\nFrame Time\n: 0.025\n", "Frames:\n2\nFrame Time:\n0.025\n"}) {
    const BvhClip clip = read_head(head);
    EXPECT_EQ(clip.motion.frame_time_s(), 0.025) << head;
    EXPECT_EQ(rows_of(clip), kValues) << head;
    EXPECT_EQ(written(clip), std::string(kOneJoint) + "MOTION\n" + head + kRows);
  }
}

TEST(FrameTimeText, ALineWithoutValueIsLeftOutAndSaidSo) {
  const BvhClip clip = read_head("Frames: 2\nFrame Time:\nFrame Time: 0.025\n");
  EXPECT_EQ(clip.motion.frame_time_s(), 0.025);
  expect_finding(clip, Code::UnexpectedToken, {13, 1});
  EXPECT_NE(written(clip).find("Frames: 2\nFrame Time: 0.025\n"), std::string::npos);
}

TEST(OffsetText, CommentsBetweenTheNumbersArePassed) {
  const std::string head = "HIERARCHY\nROOT a\n{\nOFFSET ";
  const std::string tail = "\nCHANNELS 1 Zrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n5\n";
  for (const std::string offset : {"1.0 /* up */ 2 3", "# cm\n1 2 3", "1 // x\n2 // y\n3"}) {
    const BvhClip clip = read_or_fail(head + offset + tail);
    EXPECT_EQ(clip.skeleton.offset(0), glm::dvec3(1.0, 2.0, 3.0)) << offset;
    EXPECT_EQ(written(clip), head + offset + tail);
  }
}

TEST(ChannelNames, GluedByCommasOrInBracketsAreTold) {
  const std::string head = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 ";
  const std::string tail = "\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n5 6 7\n";
  for (const std::string names : {"Zrotation,Xrotation,Yrotation", "['Zrotation', 'Xrotation', 'Yrotation']", "(Zrotation;Xrotation;Yrotation)"}) {
    const BvhClip clip = read_or_fail(head + names + tail);
    EXPECT_EQ(euler_order_label(clip.skeleton, 0), "ZXY") << names;
    EXPECT_NE(clip.diagnostics.find(Code::UnexpectedToken), nullptr) << names;
    EXPECT_EQ(written(clip), head + "Zrotation Xrotation Yrotation" + tail);
  }
}

TEST(CommasBetweenNumbers, MayHaveBlanksOnBothSides) {
  const BvhClip clip = read_or_fail(one_joint_file("2", "1 , 2.5 , 3\n4.5 , 5 , 6\n"));
  EXPECT_EQ(rows_of(clip), (Rows{{1, 2.5, 3}, {4.5, 5, 6}}));
  EXPECT_NE(clip.diagnostics.find(Code::CommaBetweenNumbers), nullptr);
}

}  // namespace
}  // namespace marey
