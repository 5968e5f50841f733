#include "core/signal/range_statistics.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <vector>

namespace marey::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(RangeStatistics, AreThoseOfTheFiniteSamplesOfTheRange) {
  const std::vector<double> curve = {100, 3, kNan, -4, 3, -4, 200};
  const auto found = find_range_statistics(curve, {1, 5});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->least, -4);
  EXPECT_EQ(found->least_frame, 3);
  EXPECT_EQ(found->greatest, 3);
  EXPECT_EQ(found->greatest_frame, 1);
  EXPECT_EQ(found->count, 4);
  EXPECT_DOUBLE_EQ(found->mean, -0.5);
  EXPECT_DOUBLE_EQ(found->rms, std::sqrt(12.5));
}

TEST(RangeStatistics, OfASineAreItsAmplitudeAndItsRoot) {
  std::vector<double> curve;
  for (int i = 0; i < 1000; ++i) curve.push_back(5.0 * std::sin(2.0 * 3.14159265358979323846 * i / 250.0));
  const auto found = find_range_statistics(curve, {0, 1000});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->mean, 0.0, 1e-12);
  EXPECT_NEAR(found->rms, 5.0 / std::sqrt(2.0), 1e-12);
}

TEST(RangeStatistics, AreNoneWithoutSamplesAndDoNotOverflow) {
  EXPECT_FALSE(find_range_statistics(std::vector<double>{kNan, kNan}, {0, 2}));
  EXPECT_FALSE(find_range_statistics(std::vector<double>{1, 2}, {1, 0}));
  EXPECT_DOUBLE_EQ(find_range_statistics(std::vector<double>{1e300, -1e300}, {0, 2})->rms, 1e300);
  EXPECT_EQ(find_range_statistics(std::vector<double>{0, 0}, {0, 2})->rms, 0.0);
}

}  // namespace
}  // namespace marey::test
