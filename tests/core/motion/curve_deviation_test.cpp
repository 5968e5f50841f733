#include "core/motion/curve_deviation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace marey::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

CurveDeviation deviation(const std::vector<double>& a, const std::vector<double>& b) { return find_deviation(a, b); }

TEST(CurveDeviation, IsTheLargestDifferenceAndTheRootMeanSquare) {
  const CurveDeviation found = deviation({1, 2, 3, 4}, {1, 5, 3, 0});
  EXPECT_EQ(found.largest, 4.0);
  EXPECT_EQ(found.at, 3);
  EXPECT_DOUBLE_EQ(found.rms, 2.5);
}

TEST(CurveDeviation, NamesTheFirstOfEquals) { EXPECT_EQ(deviation({0, 1, 0, 1}, {0, 0, 0, 0}).at, 1); }

TEST(CurveDeviation, IgnoresPairsThatAreNotFinite) {
  const CurveDeviation found = deviation({kNan, 1, kInfinity, 3}, {0, 2, 7, -kInfinity});
  EXPECT_EQ(found.largest, 1.0);
  EXPECT_EQ(found.at, 1);
  EXPECT_EQ(found.rms, 1.0);
  EXPECT_EQ(deviation({kNan}, {kNan}).rms, 0.0);
  EXPECT_EQ(deviation({}, {}).largest, 0.0);
}

TEST(CurveDeviation, SquaresNeitherOverflowNorVanish) {
  EXPECT_DOUBLE_EQ(deviation({3e200, 4e200}, {0, 0}).rms, std::sqrt(12.5) * 1e200);
  EXPECT_DOUBLE_EQ(deviation({3e-200, 4e-200}, {0, 0}).rms, std::sqrt(12.5) * 1e-200);
  EXPECT_EQ(deviation({5, 5}, {5, 5}).rms, 0.0);
}

}  // namespace
}  // namespace marey::test
