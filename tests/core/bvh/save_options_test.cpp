#include "core/bvh/save_options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/core/bvh/bvh_texts.h"
#include "tests/core/editing/generated_clips.h"

namespace marey::test {
namespace {

std::string saved(const std::string& text, const SaveOptions& options) {
  const BvhClip clip = read_or_fail(text);
  return write_bvh(clip.skeleton, clip.motion, clip.style, options);
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
  return text;
}

TEST(SaveOptions, ThatAskForNothingLeaveTheBytes) {
  const std::string text = one_joint_file("3", "1.0 2 3.00\n4.50  5e0 6\n\t7 +8 9.000\n");
  EXPECT_EQ(saved(text, {}), text);
}

TEST(SaveOptions, DecimalsAreThoseOfEveryNumberButTheFrameTime) {
  const std::string text = one_joint_file("2", "1.0 2 3.125\n-0.001  5e0 179.999\n");
  std::string expected = one_joint_file("2", "1.00 2.00 3.12\n0.00  5.00 180.00\n");
  expected = replaced(expected, "0.0 0.0 0.0", "0.00 0.00 0.00");
  expected = replaced(expected, "0.0 10.0 0.0", "0.00 10.00 0.00");
  EXPECT_EQ(saved(text, {.decimals = 2}), expected);
  expected = replaced(one_joint_file("2", "1 2 3\n0  5 180\n"), "0.0 0.0 0.0", "0 0 0");
  EXPECT_EQ(saved(text, {.decimals = 0}), replaced(expected, "0.0 10.0 0.0", "0 10 0"));
}

TEST(SaveOptions, RoundedNumbersAreTheNearestAndReadBackTheSame) {
  Random random(11);
  for (int round = 0; round < 200; ++round) {
    const Clip clip = make_random_clip(random);
    const int decimals = random.below(kMostSavedDecimals + 1);
    Motion motion = clip.motion;
    for (ChannelIndex c = 0; c < motion.channel_count(); ++c) {
      for (double& sample : motion.channel_samples(c)) sample = random.between(-200, 200);
    }
    const BvhClip again = read_or_fail(write_bvh(clip.skeleton, motion, {}, {.decimals = decimals}));
    ASSERT_EQ(again.motion.frame_count(), motion.frame_count());
    const double half = 0.5 * std::pow(10.0, -decimals);
    const RoundingCost cost = measure_rounding(clip.skeleton, motion, {}, decimals);
    EXPECT_LE(cost.largest, half + 1e-13);
    double largest = 0.0;
    for (std::size_t i = 0; i < motion.samples().size(); ++i) {
      largest = std::max(largest, std::abs(motion.samples()[i] - again.motion.samples()[i]));
    }
    EXPECT_LE(largest, half + 1e-13);
    EXPECT_LE(largest, cost.largest + 1e-13);
  }
}

TEST(SaveOptions, LineEndsAreThoseOfTheWholeFile) {
  const std::string text = one_joint_file("2", "1 2 3\r\n4 5 6\r\n");
  const std::string all_lf = replaced(text, "\r\n", "\n");
  EXPECT_EQ(saved(text, {.line_end = LineEnd::Lf}), all_lf);
  EXPECT_EQ(saved(text, {.line_end = LineEnd::CrLf}), replaced(all_lf, "\n", "\r\n"));
  EXPECT_EQ(saved(replaced(all_lf, "\n", "\r"), {.line_end = LineEnd::Lf}), all_lf);
}

TEST(SaveOptions, AFrameRangeKeepsTheBytesOfItsFrames) {
  const std::string text = one_joint_file("4", "1.0 2 3.00\n4.50  5e0 6\n7 +8 9.000\n1 1 1\n");
  EXPECT_EQ(saved(text, {.frames = {1, 2}}), one_joint_file("2", "4.50  5e0 6\n7 +8 9.000\n"));
  EXPECT_EQ(saved(text, {.frames = {3, 1}}), one_joint_file("1", "1 1 1\n"));
}

TEST(SaveOptions, KeepUtf16) {
  const BvhClip clip = read_or_fail(one_joint_file("1", "1 2 3\n"));
  BvhStyle style = clip.style;
  style.encoding = TextEncoding::Utf16BigEndian;
  const std::string bytes = write_bvh(clip.skeleton, clip.motion, style, {.line_end = LineEnd::CrLf});
  EXPECT_EQ(bytes.substr(0, 4), std::string("\xfe\xff\0H", 4));
  EXPECT_NE(bytes.find(std::string("\0\r\0\n", 4)), std::string::npos);
}

}  // namespace
}  // namespace marey::test
