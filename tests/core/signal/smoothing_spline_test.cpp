#include "core/signal/smoothing_spline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/base/index.h"

namespace marey {
namespace {

constexpr double kRate_hz = 100.0;

std::vector<double> sampled(int count, double (*function)(double)) {
  std::vector<double> curve(idx(count));
  for (int i = 0; i < count; ++i) curve[idx(i)] = function(i / kRate_hz);
  return curve;
}

double two_sines(double t) { return std::sin(2 * std::numbers::pi * t) + 0.3 * std::sin(6 * std::numbers::pi * t + 0.5); }
double velocity(double t) {
  constexpr double w = 2 * std::numbers::pi;
  return w * std::cos(w * t) + 0.9 * w * std::cos(3 * w * t + 0.5);
}
double acceleration(double t) {
  constexpr double w = 2 * std::numbers::pi;
  return -w * w * std::sin(w * t) - 2.7 * w * w * std::sin(3 * w * t + 0.5);
}

/// The noise of the shared accuracy table: uniform, by a linear congruential generator from 12345 on.
std::vector<double> with_noise(std::vector<double> curve) {
  std::uint32_t state = 12345;
  for (double& value : curve) {
    state = 1664525u * state + 1013904223u;
    value += 0.005 * std::sqrt(3.0) * (2.0 * (state / 4294967296.0) - 1.0);
  }
  return curve;
}

double rms_error(const std::vector<double>& curve, double (*truth)(double)) {
  double sum = 0.0;
  for (int i = 10; i < 190; ++i) {
    const double error = curve[idx(i)] - truth(i / kRate_hz);
    sum += error * error;
  }
  return std::sqrt(sum / 180.0);
}

TEST(SmoothingSpline, WithoutSmoothingGoesThroughTheSamples) {
  const std::vector<double> curve = sampled(200, two_sines);
  const SplineFit fit = fit_smoothing_spline(curve, kRate_hz, 0.0);
  for (std::size_t i = 0; i < curve.size(); ++i) EXPECT_NEAR(fit.values[i], curve[i], 1e-12);
  EXPECT_LT(rms_error(fit.first, velocity), 1e-6);
  EXPECT_LT(rms_error(fit.second, acceleration), 1e-3);
  EXPECT_NEAR(fit.freedom, 200.0, 1e-9);
}

// Polynomials below the third degree have no third derivative: nothing is smoothed away.
TEST(SmoothingSpline, KeepsParabolas) {
  const std::vector<double> curve = sampled(60, [](double t) { return 3.0 - 2.0 * t + 5.0 * t * t; });
  for (const double lambda : {0.0, 1e-6, 1.0}) {
    const SplineFit fit = fit_smoothing_spline(curve, kRate_hz, lambda);
    for (int i = 0; i < 60; ++i) {
      EXPECT_NEAR(fit.values[idx(i)], curve[idx(i)], 1e-9);
      EXPECT_NEAR(fit.first[idx(i)], -2.0 + 10.0 * i / kRate_hz, 1e-6);
      EXPECT_NEAR(fit.second[idx(i)], 10.0, 1e-3);
    }
  }
}

// Accuracy table of the shared theory, section 4: lambda 10^-8.5, the best one of a coarse grid, leaves 38.95 numbers and
// errors of 0.00189, 0.0471 and 2.097.
TEST(SmoothingSpline, HasTheErrorsOfTheAccuracyTable) {
  const SplineFit fit = fit_smoothing_spline(with_noise(sampled(200, two_sines)), kRate_hz, std::pow(10.0, -8.5));
  EXPECT_NEAR(fit.freedom, 38.95, 0.01);
  EXPECT_NEAR(rms_error(fit.values, two_sines), 0.00189, 2e-5);
  EXPECT_NEAR(rms_error(fit.first, velocity), 0.0471, 5e-4);
  EXPECT_NEAR(rms_error(fit.second, acceleration), 2.097, 0.02);
}

TEST(SmoothingSpline, FindsTheSmoothingOfLeastCrossValidation) {
  const std::vector<double> curve = with_noise(sampled(200, two_sines));
  const SplineFit best = fit_smoothing_spline(curve, kRate_hz);
  EXPECT_NEAR(best.smoothing, 3.5e-9, 0.1e-9);
  for (const double factor : {0.8, 1.25}) EXPECT_GT(fit_smoothing_spline(curve, kRate_hz, factor * best.smoothing).gcv, best.gcv);
  EXPECT_LT(rms_error(best.second, acceleration), 2.097);
}

TEST(SmoothingSpline, LeavesAKnownNoise) {
  const std::vector<double> curve = with_noise(sampled(200, two_sines));
  const SplineFit fit = fit_smoothing_spline(curve, kRate_hz, std::optional(0.005));
  double sum = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) sum += (curve[i] - fit.values[i]) * (curve[i] - fit.values[i]);
  EXPECT_NEAR(std::sqrt(sum / 200.0), 0.005, 1e-6);
}

TEST(SmoothingSpline, TakesTheShortestAndLongCurves) {
  const std::vector<double> shortest = {1, 2, 0, 1, 3, 2};
  const SplineFit fit = fit_smoothing_spline(shortest, 30.0);
  EXPECT_EQ(fit.values.size(), 6u);
  const std::vector<double> longer = with_noise(sampled(20000, two_sines));
  EXPECT_LT(rms_error(fit_smoothing_spline(longer, kRate_hz).second, acceleration), 4.0);
}

}  // namespace
}  // namespace marey
