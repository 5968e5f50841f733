#include "core/math/sincos.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace marey {
namespace {

// Distance in units of the last place of the reference.
double ulps(double value, long double reference) {
  const double rounded = std::abs(static_cast<double>(reference));
  const double ulp = std::nextafter(rounded, HUGE_VAL) - rounded;
  return static_cast<double>(std::abs(static_cast<long double>(value) - reference)) / ulp;
}

// Worst error of both functions at an angle. fmod is exact; near multiples of 90 degrees the reference takes the small
// remainder, where the library's own sine of a rounded number of radians would lose digits.
double worst_error_ulps(double angle_deg) {
  constexpr long double kRadians = std::numbers::pi_v<long double> / 180.0L;
  double turn = std::fmod(angle_deg, 360.0);
  const double quarter = std::round(turn / 90.0);
  const long double rest = static_cast<long double>(turn - 90.0 * quarter) * kRadians;
  const int which = (static_cast<int>(quarter) + 4) % 4;
  const long double sines[4] = {std::sin(rest), std::cos(rest), -std::sin(rest), -std::cos(rest)};
  const SinCos<double> found = sincos_deg(angle_deg);
  return std::max(ulps(found.sine, sines[which]), ulps(found.cosine, sines[(which + 1) % 4]));
}

TEST(SinCos, IsWithinTwoUlpOverNormalAngles) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> angle(-1000.0, 1000.0);
  double worst = 0.0;
  for (int i = 0; i < 200'000; ++i) worst = std::max(worst, worst_error_ulps(angle(random)));
  for (int i = -72'000; i <= 72'000; ++i) worst = std::max(worst, worst_error_ulps(i * 0.01));
  EXPECT_LE(worst, 2.0);
  RecordProperty("worst_error_ulps", std::to_string(worst));
}

TEST(SinCos, ReducesAnglesOfAnySizeExactly) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> exponent(-1000.0, 1000.0);
  for (int i = 0; i < 20'000; ++i) {
    const double angle_deg = std::exp2(exponent(random)) * (i % 2 == 0 ? 1.0 : -1.0);
    EXPECT_LE(worst_error_ulps(angle_deg), 2.0) << angle_deg;
  }
  for (double large : {1099511627776.0, 1099511627777.0, 1e300}) EXPECT_LE(worst_error_ulps(large), 2.0) << large;
}

TEST(SinCos, IsExactAtQuarterTurns) {
  const double sines[4] = {0.0, 1.0, 0.0, -1.0};
  for (int quarter = -4000; quarter <= 4000; ++quarter) {
    const SinCos<double> found = sincos_deg(90.0 * quarter);
    EXPECT_EQ(found.sine, sines[(quarter + 4000) % 4]) << quarter;
    EXPECT_EQ(found.cosine, sines[(quarter + 4001) % 4]) << quarter;
  }
}

TEST(SinCos, GivesNotANumberForWhatIsNoAngle) {
  for (double angle_deg : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL}) {
    EXPECT_TRUE(std::isnan(sincos_deg(angle_deg).sine));
    EXPECT_TRUE(std::isnan(sincos_deg(angle_deg).cosine));
  }
}

TEST(SinCos, GivesTheSameBitsForLanes) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-40.0, 60.0);
  for (int i = 0; i < 20'000; ++i) {
    const Lanes angles = {std::exp2(exponent(random)), -std::exp2(exponent(random))};
    const SinCos<Lanes> found = sincos_deg(angles);
    for (int lane = 0; lane < kLaneCount; ++lane) {
      EXPECT_EQ(found.sine[lane], sincos_deg(angles[lane]).sine);
      EXPECT_EQ(found.cosine[lane], sincos_deg(angles[lane]).cosine);
    }
  }
}

TEST(SinCos, KeepsNotANumberInItsLane) {
  const SinCos<Lanes> found = sincos_deg(Lanes{std::numeric_limits<double>::quiet_NaN(), 30.0});
  EXPECT_TRUE(std::isnan(found.sine[0]));
  EXPECT_EQ(found.sine[1], sincos_deg(30.0).sine);
}

// Sines and cosines folded into one number, first computed with g++ 12 on x86-64. No operation may differ elsewhere.
TEST(SinCos, HasTheSameBitsEverywhere) {
  std::uint64_t folded = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const SinCos<double> found = sincos_deg(0.123456789 * i - 60'000.0);
    std::uint64_t bits[2];
    std::memcpy(bits, &found, sizeof(bits));
    for (std::uint64_t b : bits) folded = (folded ^ b) * 1099511628211U;
  }
  EXPECT_EQ(folded, 565709319595156315U);
}

}  // namespace
}  // namespace marey
