#include "core/motion/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace marey {
namespace {

TEST(Motion, KeepsEachChannelContiguous) {
  std::vector<double> samples(12);
  std::iota(samples.begin(), samples.end(), 0.0);
  const Motion motion(3, 4, 0.1, samples);
  EXPECT_EQ(motion.sample(2, 1), 9.0);
  EXPECT_EQ(motion.channel_samples(1).front(), 4.0);
  EXPECT_EQ(motion.channel_samples(1).size(), 4U);
}

TEST(Motion, StartsAtZero) {
  const Motion motion(2, 3, 0.1);
  for (double sample : motion.samples()) EXPECT_EQ(sample, 0.0);
  EXPECT_EQ(motion.samples().size(), 6U);
}

TEST(Motion, LastsFromFirstToLastFrame) {
  EXPECT_DOUBLE_EQ(Motion(1, 23, 0.033333).duration_s(), 22 * 0.033333);
  EXPECT_EQ(Motion(1, 1, 0.1).duration_s(), 0.0);
  EXPECT_EQ(Motion(1, 0, 0.1).duration_s(), 0.0);
}

TEST(DisplayFrameRate, SnapsToTheRateThatWasCutToItsDecimals) {
  EXPECT_EQ(display_frame_rate_hz(0.0083333), 120.0);
  EXPECT_EQ(display_frame_rate_hz(0.033333), 30.0);
  EXPECT_EQ(display_frame_rate_hz(0.0166667), 60.0);
  EXPECT_EQ(display_frame_rate_hz(0.041667), 24.0);
  EXPECT_EQ(display_frame_rate_hz(0.04), 25.0);
  EXPECT_DOUBLE_EQ(display_frame_rate_hz(1.001 / 30.0), 30.0 / 1.001);
}

TEST(DisplayFrameRate, KeepsRatesThatAreNotRound) {
  EXPECT_DOUBLE_EQ(display_frame_rate_hz(0.03), 1.0 / 0.03);
  EXPECT_DOUBLE_EQ(display_frame_rate_hz(1.0 / 12.5), 12.5);
}

}  // namespace
}  // namespace marey
