#include "core/biomechanics/rate_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/math/angle.h"
#include "tests/core/biomechanics/body_fixtures.h"

namespace marey::test {
namespace {

/// A hinge that swings once a second, sampled so often.
BodyMotion make_swing(double rate_hz, double noise_rad = 0.0) {
  std::mt19937 generator(3);
  std::normal_distribution<double> noise(0.0, 1.0);
  const Skeleton skeleton = figures::make_skeleton({{"Body", kNoParent, glm::dvec3(0.0), figures::channels("Z"), {glm::dvec3(0, 1, 0)}}});
  const Clip clip = make_moving(skeleton, static_cast<int>(4.0 * rate_hz), rate_hz, [&](FrameIndex frame, ChannelIndex) {
    return to_degrees(0.5 * std::sin(2.0 * std::numbers::pi * (frame / rate_hz)) + noise_rad * noise(generator));
  });
  return *find_body_motion(clip, {}, 1.0 / rate_hz, 1.0);
}

// Central differences of a sine are its derivatives times sin x / x and (sin(x / 2) / (x / 2))^2, where x is the phase of a frame.
TEST(RateCheck, EstimatesTheErrorOfDifferences) {
  for (const double rate_hz : {6.0, 8.0, 12.0, 30.0, 120.0}) {
    const RateCheck check = check_rate(make_swing(rate_hz));
    const double x = 2.0 * std::numbers::pi / rate_hz;
    const double half = std::sin(0.5 * x) / (0.5 * x);
    const double velocity_error = 1.0 / (std::sin(x) / x) - 1.0;
    const double acceleration_error = 1.0 / (half * half) - 1.0;
    EXPECT_NEAR(check.velocity_error, velocity_error, 0.25 * velocity_error) << rate_hz;
    EXPECT_NEAR(check.acceleration_error, acceleration_error, 0.25 * acceleration_error) << rate_hz;
  }
}

TEST(RateCheck, WarnsOfWhatTheRateDoesNotCarry) {
  const auto warning = [](double rate_hz, bool with_accelerations, double noise_rad = 0.0) {
    return describe_rate(check_rate(make_swing(rate_hz, noise_rad)), 1.0 / rate_hz, with_accelerations);
  };
  EXPECT_EQ(warning(120.0, true), "");
  EXPECT_THAT(warning(7.0, true), testing::StartsWith("7 frames a second do not carry the velocities: they are off by about 1"));
  EXPECT_THAT(warning(4.0, true), testing::HasSubstr("do not carry the velocities"));
  EXPECT_EQ(warning(120.0, true, 0.01), "Most of the accelerations is noise: smooth the motion, by a cut-off or a spline.");
  EXPECT_EQ(warning(120.0, false, 0.001), "");
}

TEST(RateCheck, OfTheGiantSwing) {
  const RateCheck check = check_rate(*find_body_motion(make_gymnast(), {}, 0.033333, 0.055));
  EXPECT_NEAR(check.acceleration_error, 0.04, 0.005);
  EXPECT_LT(check.velocity_error, 0.05);
  EXPECT_EQ(check_rate(BodyMotion{}).acceleration_error, 0.0);
}

}  // namespace
}  // namespace marey::test
