#include "core/bvh/limits.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "tests/core/bvh/bvh_texts.h"

namespace marey {
namespace {

using namespace test;
using Code = DiagnosticCode;

std::string repeated(std::string_view text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

std::string chain(int joints) {
  return "HIERARCHY\nROOT a { OFFSET 0 0 0 CHANNELS 1 Zrotation\n" +
         repeated("JOINT b { OFFSET 0 1 0 CHANNELS 1 Zrotation\n", joints - 1) + "End Site { OFFSET 0 1 0 }\n" +
         repeated("}\n", joints) + "MOTION\nFrames: 1\nFrame Time: 0.1\n" + repeated("1 ", joints);
}

ReadOptions with_limits(const ReadLimits& limits) { return {.strict = false, .limits = limits}; }

void expect_limit(const std::string& text, const ReadLimits& limits, Code code, const std::string& number) {
  const Error error = refusal_of(text, with_limits(limits));
  EXPECT_EQ(error.code, code);
  EXPECT_NE(error.message.find(number), std::string::npos) << error.message;
  EXPECT_GT(error.place.line, 0);
}

TEST(Limits, Joints) {
  ReadLimits limits;
  limits.max_joints = 50;
  EXPECT_EQ(read_or_fail(chain(50), with_limits(limits)).skeleton.joint_count(), 50);
  expect_limit(chain(51), limits, Code::LimitJoints, "50");
}

TEST(Limits, EndSites) {
  ReadLimits limits;
  limits.max_joints = 10;
  const std::string text = "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 0 " + repeated("End Site { OFFSET 0 1 0 } ", 11) + "}";
  expect_limit(text, limits, Code::LimitJoints, "10");
}

TEST(Limits, Depth) {
  ReadLimits limits;
  limits.max_depth = 20;
  EXPECT_EQ(read_or_fail(chain(19), with_limits(limits)).skeleton.joint_count(), 19);
  expect_limit(chain(40), limits, Code::LimitDepth, "20");
}

TEST(Limits, AHundredThousandBracesAreRefusedAtOnce) {
  for (const std::string& text : {chain(100'000), "HIERARCHY ROOT a " + repeated("{", 100'000),
                                  "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 0 " + repeated("End Site {", 100'000)}) {
    EXPECT_EQ(refusal_of(text).code, Code::LimitDepth);
  }
}

TEST(Limits, AHundredThousandClosingBracesAreOneFinding) {
  const std::string text = "HIERARCHY\nROOT a {OFFSET 0 0 0 CHANNELS 0 End Site {OFFSET 0 1 0}" + repeated("}", 100'000);
  const BvhClip clip = read_or_fail(text);
  expect_finding(clip, Code::SurplusClosingBrace);
}

TEST(Limits, Channels) {
  ReadLimits limits;
  limits.max_channels = 9;
  EXPECT_EQ(read_or_fail(chain(9), with_limits(limits)).skeleton.channel_count(), 9);
  expect_limit(chain(10), limits, Code::LimitChannels, "9");
  expect_limit("HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 12 " + repeated("Zrotation ", 12) + "}", limits,
               Code::LimitChannels, "9");
}

TEST(Limits, Frames) {
  ReadLimits limits;
  limits.max_frames = 100;
  EXPECT_EQ(read_or_fail(one_joint_file("100", repeated("1 2 3\n", 100)), with_limits(limits)).motion.frame_count(), 100);
  for (const std::string declared : {"100", "101", "5", "999999999999"}) {
    expect_limit(one_joint_file(declared, repeated("1 2 3\n", 101)), limits, Code::LimitFrames, "100");
  }
  expect_limit("HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 0 }\nMOTION\nFrames: 101\nFrame Time: 1", limits, Code::LimitFrames,
               "101");
}

TEST(Limits, Memory) {
  ReadLimits limits;
  limits.max_sample_bytes = 3 * 8 * 10;
  EXPECT_EQ(read_or_fail(one_joint_file("10", repeated("1 2 3\n", 10)), with_limits(limits)).motion.frame_count(), 10);
  expect_limit(one_joint_file("11", repeated("1 2 3\n", 11)), limits, Code::LimitMemory, "240");
}

TEST(Limits, MemoryOfAGrowingStoreCountsBothStores) {
  ReadLimits limits;
  limits.max_sample_bytes = 3 * 8 * 1000;
  const std::string growing = one_joint_file("", "1.123456789 2.123456789 3.123456789\n" + repeated("1 2 3\n", 900));
  expect_limit(growing, limits, Code::LimitMemory, "24000");
  limits.max_sample_bytes *= 3;
  EXPECT_EQ(read_or_fail(growing, with_limits(limits)).motion.frame_count(), 901);
}

TEST(Limits, MemoryOfTextAndSamplesTogether) {
  const std::string rows = one_joint_file("1000", repeated("1 2 3\n", 1000));
  const auto needed = static_cast<std::int64_t>(rows.size()) + 1000 * 3 * 8 + 200;
  ReadLimits limits;
  limits.max_bytes = needed;
  EXPECT_EQ(read_or_fail(rows, with_limits(limits)).motion.frame_count(), 1000);
  limits.max_bytes = needed - 400;
  expect_limit(rows, limits, Code::LimitMemory, "bytes");
  const std::string tail = one_joint_file("1", "1 2 3\n") + repeated("notes ", 1000);
  limits.max_bytes = static_cast<std::int64_t>(tail.size()) + 1000;
  expect_limit(tail, limits, Code::LimitMemory, "bytes");
  limits.max_bytes = static_cast<std::int64_t>(tail.size()) - 1;
  EXPECT_EQ(refusal_of(tail, with_limits(limits)).code, Code::LimitMemory);
}

TEST(Limits, BlocksThatNoJointAnnounces) {
  ReadLimits limits;
  limits.max_joints = 10;
  const std::string text = "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 0 " + repeated("{ } ", 11) + "}";
  expect_limit(text, limits, Code::LimitJoints, "10");
}

TEST(Limits, ADeclaredCountAllocatesNothingByItself) {
  // 10 million frames of 90 channels would be 7 GB.
  const std::string text = "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 90 " + repeated("Zrotation ", 90) +
                           "}\nMOTION\nFrames: 10000000\nFrame Time: 0.1\n" + repeated("1 ", 90) + "\n";
  EXPECT_EQ(read_or_fail(text).motion.frame_count(), 1);
}

TEST(Limits, NothingTakesSquareTime) {
  const auto begin = std::chrono::steady_clock::now();
  const int n = 400'000;
  (void)read_bvh(one_joint_file("1", repeated("1 2 3 ", n)));
  (void)read_bvh(one_joint_file("7", repeated("1\n", n)));
  (void)read_bvh(one_joint_file("7", repeated("1 2\n", n)));
  (void)read_bvh(one_joint_file("7", repeated("1 2 3 4\n", n)));
  (void)read_bvh(one_joint_file("7", repeated("x ", n)));
  (void)read_bvh(one_joint_file("9999999", repeated("1 2 3\nx\n", n)));
  (void)read_bvh(one_joint_file("9999999", repeated("# no\n", n)));
  (void)read_bvh(one_joint_file("9999999", repeated("1 2 3\nx y\n", n)));
  (void)read_bvh(one_joint_file("9999999", repeated("/* no\n", n)));
  (void)read_bvh(one_joint_file("1", repeated("1\u00a02 3 ", n)));
  (void)read_bvh("HIERARCHY ROOT a" + repeated("\u00a0b", n));
  (void)read_bvh("HIERARCHY ROOT a" + repeated("\u00a0", n));
  (void)read_bvh(repeated("Motion of a walk\n", n) + std::string(kOneJoint));
  (void)read_bvh(std::string(kOneJoint) + repeated("x ", n));
  (void)read_bvh("HIERARCHY ROOT a { OFFSET " + repeated("1 ", n));
  (void)read_bvh("HIERARCHY ROOT a { CHANNELS 3 " + repeated("x ", n));
  (void)read_bvh("HIERARCHY ROOT a { CHANNELS 3 " + repeated("Zrotation,", n));
  (void)read_bvh(std::string(kOneJoint) + "MOTION " + repeated("Frame Time: 1 ", n));
  (void)read_bvh("HIERARCHY\n" + repeated("ROOT a { OFFSET 0 0 0 } }\n", 9'000));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
}

}  // namespace
}  // namespace marey
