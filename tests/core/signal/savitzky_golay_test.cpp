#include "core/signal/savitzky_golay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/index.h"
#include "tests/core/signal/curves.h"

namespace marey::test {
namespace {

using testing::DoubleNear;
using testing::Each;
using testing::Pointwise;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> filtered(const std::vector<double>& curve, const SavitzkyGolay& filter) {
  std::vector<double> result(curve.size());
  compute_savitzky_golay(curve, filter, result);
  return result;
}

TEST(SavitzkyGolay, HasTheWeightsOfTheTables) {
  const auto weights = [](int window, int degree, int derivative, double divisor) {
    std::vector<double> found = make_savitzky_golay_weights({window, degree, derivative}, 0);
    for (double& weight : found) weight *= divisor;
    return found;
  };
  const auto same = [](const std::vector<double>& expected) { return Pointwise(DoubleNear(1e-12), expected); };
  EXPECT_THAT(weights(5, 2, 0, 35), same({-3, 12, 17, 12, -3}));
  EXPECT_THAT(weights(5, 2, 1, 10), same({-2, -1, 0, 1, 2}));
  EXPECT_THAT(weights(5, 2, 2, 7), same({2, -1, -2, -1, 2}));
  EXPECT_THAT(weights(7, 3, 0, 21), same({-2, 3, 6, 7, 6, 3, -2}));
  EXPECT_THAT(weights(1, 0, 0, 1), same({1}));
}

// Polynomials up to the degree come back everywhere, and so do their derivatives, up to the ends.
TEST(SavitzkyGolay, KeepsPolynomials) {
  const auto cubic = [](double x) { return 2.0 - 0.5 * x + 0.03 * x * x - 0.001 * x * x * x; };
  const auto first = [](double x) { return -0.5 + 0.06 * x - 0.003 * x * x; };
  const auto second = [](double x) { return 0.06 - 0.006 * x; };
  std::vector<double> curve;
  for (int i = 0; i < 40; ++i) curve.push_back(cubic(i));
  for (const int window : {5, 7, 15, 39, 301}) {
    for (const int degree : {3, 4}) {
      const std::vector<double> smooth = filtered(curve, {window, degree, 0});
      const std::vector<double> velocity = filtered(curve, {window, degree, 1});
      const std::vector<double> acceleration = filtered(curve, {window, degree, 2});
      for (int i = 0; i < 40; ++i) {
        EXPECT_NEAR(smooth[idx(i)], cubic(i), 1e-9) << window << " " << i;
        EXPECT_NEAR(velocity[idx(i)], first(i), 1e-9) << window << " " << i;
        EXPECT_NEAR(acceleration[idx(i)], second(i), 1e-9) << window << " " << i;
      }
    }
  }
}

TEST(SavitzkyGolay, KeepsConstantsToTheBitAndShortCurves) {
  for (const int count : {0, 1, 2, 3, 6, 50}) {
    EXPECT_THAT(filtered(make_line(count, 93.042686, 0), {7, 3, 0}), Each(93.042686));
    const std::vector<double> line = make_line(count, -20.0, 0.37);
    // Two samples are a window of one.
    EXPECT_THAT(filtered(line, {7, 3, 0}), Pointwise(DoubleNear(1e-12), line)) << count;
  }
}

TEST(SavitzkyGolay, MissingSamplesStay) {
  std::vector<double> line = make_line(30, 5.0, -1.5);
  for (const int missing : {0, 9, 10, 29}) line[idx(missing)] = kNan;
  const std::vector<double> result = filtered(line, {7, 2, 0});
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (std::isnan(line[i])) {
      EXPECT_TRUE(std::isnan(result[i])) << i;
    } else {
      EXPECT_NEAR(result[i], line[i], 1e-12) << i;
    }
  }
}

TEST(SavitzkyGolay, HasTheAccuracyOfTheReference) {
  const SyntheticMovement movement = make_synthetic_movement();
  struct Row {
    int window, degree;
    double angle, velocity, acceleration;
  };
  constexpr Row kRows[] = {
      {15, 4, 0.00219, 0.0663, 4.610}, {21, 4, 0.00197, 0.1112, 2.284}, {25, 5, 0.00204, 0.0475, 2.685}};
  for (const Row& row : kRows) {
    const auto derivative = [&](int order) {
      std::vector<double> result = filtered(movement.noisy, {row.window, row.degree, order});
      for (double& value : result) value *= std::pow(SyntheticMovement::kRateHz, order);
      return result;
    };
    EXPECT_NEAR(rms_error(derivative(0), movement.angle), row.angle, 0.006 * row.angle);
    EXPECT_NEAR(rms_error(derivative(1), movement.velocity), row.velocity, 0.006 * row.velocity);
    EXPECT_NEAR(rms_error(derivative(2), movement.acceleration), row.acceleration, 0.006 * row.acceleration);
  }
}

}  // namespace
}  // namespace marey::test
