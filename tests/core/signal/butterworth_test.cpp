#include "core/signal/butterworth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/index.h"
#include "core/signal/derivative.h"
#include "core/signal/residual_analysis.h"
#include "tests/core/signal/curves.h"

namespace marey::test {
namespace {

using testing::DoubleNear;
using testing::Each;
using testing::Pointwise;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> filtered(const std::vector<double>& curve, double cutoff_hz, double rate_hz) {
  std::vector<double> result(curve.size());
  compute_butterworth(curve, cutoff_hz, rate_hz, result);
  return result;
}

// Winter's printed example, and what scipy.signal.butter gives for the corrected cut-offs.
TEST(Butterworth, HasTheCoefficientsOfTheBooks) {
  struct Row {
    double cutoff_hz, rate_hz;
    int passes;
    double a0, b1, b2;
  };
  constexpr Row kRows[] = {
      {6, 60, 1, 0.06745527, 1.14298050, -0.41280160},  {6, 60, 2, 0.09444674, 0.96264131, -0.34042828},
      {6, 100, 2, 0.04059468, 1.35474882, -0.51712754}, {6, 120, 2, 0.02956907, 1.45810386, -0.57638016},
      {10, 120, 2, 0.07043104, 1.12184136, -0.40356553}, {5, 30, 2, 0.20425381, 0.38023186, -0.19724711}};
  for (const Row& row : kRows) {
    const ButterworthCoefficients f = make_butterworth(row.cutoff_hz, row.rate_hz, row.passes);
    EXPECT_NEAR(f.a0, row.a0, 5e-9);
    EXPECT_NEAR(f.a1, 2.0 * row.a0, 1e-8);
    EXPECT_NEAR(f.a2, row.a0, 5e-9);
    EXPECT_NEAR(f.b1, row.b1, 5e-9);
    EXPECT_NEAR(f.b2, row.b2, 5e-9);
  }
}

TEST(Butterworth, HasGainOneAtRestAndTheHalfPowerAtTheCutoff) {
  for (const double rate_hz : {30.0, 60.0, 119.88, 500.0}) {
    for (const double share : {0.01, 0.05, 0.2, 0.45}) {
      for (const int passes : {1, 2, 3}) {
        const double cutoff_hz = share * rate_hz;
        const ButterworthCoefficients f = make_butterworth(cutoff_hz, rate_hz, passes);
        EXPECT_NEAR(butterworth_gain(f, 0.0, rate_hz), 1.0, 1e-10);
        EXPECT_NEAR(std::pow(butterworth_gain(f, cutoff_hz, rate_hz), passes), std::numbers::sqrt2 / 2.0, 1e-9);
      }
    }
  }
  const ButterworthCoefficients f = make_butterworth(6, 120, 2);
  const double expected[][2] = {{1.5, 0.998434}, {3, 0.975369}, {6, 0.707107}, {10, 0.227635}};
  for (const auto& [frequency_hz, gain] : expected) EXPECT_NEAR(std::pow(butterworth_gain(f, frequency_hz, 120), 2), gain, 5e-7);
}

// What the curve says, not only what the coefficients promise: without lag, by the gain of two passes.
TEST(Butterworth, ASineShrinksByTheGainAndKeepsItsPhase) {
  for (const double frequency_hz : {1.5, 3.0, 6.0, 10.0}) {
    std::vector<double> sine;
    for (int i = 0; i < 1200; ++i) sine.push_back(std::sin(2.0 * std::numbers::pi * frequency_hz * i / 120.0));
    const double gain = std::pow(butterworth_gain(make_butterworth(6, 120, 2), frequency_hz, 120), 2);
    const std::vector<double> result = filtered(sine, 6, 120);
    for (std::size_t i = 200; i < 1000; ++i) ASSERT_NEAR(result[i], gain * sine[i], 1e-9) << frequency_hz << " " << i;
  }
}

TEST(Butterworth, KeepsConstantsToTheBitAndLinesUpToTheEnds) {
  for (const int count : {0, 1, 2, 3, 10, 500}) {
    for (const double cutoff_hz : {0.01, 1.0, 6.0, 14.9}) {
      EXPECT_THAT(filtered(make_line(count, 93.042686, 0), cutoff_hz, 30), Each(93.042686));
      const std::vector<double> line = make_line(count, -20.0, 0.37);
      EXPECT_THAT(filtered(line, cutoff_hz, 30), Pointwise(DoubleNear(1e-12), line)) << count << " " << cutoff_hz;
    }
  }
}

TEST(Butterworth, MissingSamplesStayAndLinesAroundThemToo) {
  std::vector<double> line = make_line(60, 5.0, -1.5);
  for (const int missing : {0, 1, 20, 21, 40, 59}) line[idx(missing)] = kNan;
  line[30] = std::numeric_limits<double>::infinity();
  const std::vector<double> result = filtered(line, 4, 30);
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (std::isnan(line[i])) {
      EXPECT_TRUE(std::isnan(result[i])) << i;
    } else {
      EXPECT_TRUE(result[i] == line[i] || std::abs(result[i] - line[i]) < 1e-12) << i;
    }
  }
  EXPECT_THAT(filtered({kNan, kNan, kNan, kNan}, 4, 30), Each(testing::IsNan()));
}

TEST(Butterworth, KnowsNoDirection) {
  const std::vector<double> forward = make_synthetic_movement().noisy;
  const std::vector<double> backward(forward.rbegin(), forward.rend());
  const std::vector<double> a = filtered(forward, 6, 100);
  const std::vector<double> b = filtered(backward, 6, 100);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[a.size() - 1 - i], 1e-8);
}

// The reference sheet's table for the synthetic movement.
TEST(Butterworth, HasTheAccuracyOfTheReference) {
  const SyntheticMovement movement = make_synthetic_movement();
  const auto errors_of = [&](const std::vector<double>& angle) {
    std::vector<double> velocity(angle.size());
    std::vector<double> acceleration(angle.size());
    compute_first_derivative(angle, SyntheticMovement::kRateHz, velocity);
    compute_second_derivative(angle, SyntheticMovement::kRateHz, acceleration);
    return std::vector<double>{rms_error(angle, movement.angle), rms_error(velocity, movement.velocity),
                               rms_error(acceleration, movement.acceleration)};
  };
  const auto near = [](double value) { return DoubleNear(value, 0.006 * value); };
  EXPECT_THAT(errors_of(movement.angle), testing::ElementsAre(0.0, near(0.02365), near(0.2213)));
  EXPECT_THAT(errors_of(movement.noisy), testing::ElementsAre(DoubleNear(0.0049, 5e-5), near(0.3636), near(123.05)));
  EXPECT_THAT(errors_of(filtered(movement.noisy, 6, 100)), testing::ElementsAre(near(0.00544), near(0.1261), near(2.492)));
  EXPECT_THAT(errors_of(filtered(movement.noisy, 7, 100)), testing::ElementsAre(near(0.00331), near(0.0871), near(2.443)));
  EXPECT_THAT(errors_of(filtered(movement.noisy, 8, 100)), testing::ElementsAre(near(0.00248), near(0.0742), near(3.036)));
}

TEST(ResidualAnalysis, SuggestsTheCutoffOfTheReference) {
  const SyntheticMovement movement = make_synthetic_movement();
  const ResidualAnalysis analysis = analyse_residuals(movement.noisy, SyntheticMovement::kRateHz);
  EXPECT_NEAR(analysis.cutoff_hz, 7.01, 0.05);
  EXPECT_NEAR(analysis.r_squared, 0.998, 0.001);
  EXPECT_GT(analysis.noise_rms, 0.003);
  EXPECT_LT(analysis.noise_rms, 0.007);
  for (std::size_t i = 1; i < analysis.residuals.size(); ++i) {
    EXPECT_GT(analysis.residuals[i].cutoff_hz, analysis.residuals[i - 1].cutoff_hz);
  }
}

TEST(ResidualAnalysis, OfNothingSuggestsNothing) {
  for (const int count : {0, 1, 2, 9, 200}) EXPECT_EQ(analyse_residuals(make_line(count, 3, 0), 100).cutoff_hz, 0.0) << count;
  EXPECT_EQ(analyse_residuals(std::vector<double>(50, kNan), 100).cutoff_hz, 0.0);
  EXPECT_EQ(analyse_residuals(make_synthetic_movement().noisy, 0.0).cutoff_hz, 0.0);
}

}  // namespace
}  // namespace marey::test
