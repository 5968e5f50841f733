#include "core/signal/gaussian_smoothing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/core/editing/generated_clips.h"

namespace marey::test {
namespace {

using testing::DoubleNear;
using testing::Each;
using testing::Pointwise;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSigmas[] = {0.1, 0.5, 1.0, 3.3, 20.0, 1e9};

std::vector<double> smoothed(const std::vector<double>& curve, double sigma_frames) {
  std::vector<double> result(curve.size());
  compute_gaussian_smoothed(curve, {0, size_of(curve)}, sigma_frames, result);
  return result;
}

std::vector<double> make_line(int count, double start, double slope) {
  std::vector<double> line;
  for (int i = 0; i < count; ++i) line.push_back(start + slope * i);
  return line;
}

TEST(GaussianSmoothing, KeepsConstantsBitByBit) {
  for (const int count : {1, 2, 3, 50}) {
    for (const double sigma : kSigmas) EXPECT_THAT(smoothed(make_line(count, 93.042686, 0), sigma), Each(93.042686));
  }
}

TEST(GaussianSmoothing, KeepsStraightLinesUpToTheEnds) {
  for (const int count : {1, 2, 3, 50, 1000}) {
    for (const double sigma : kSigmas) {
      const std::vector<double> line = make_line(count, -20.0, 0.37);
      EXPECT_THAT(smoothed(line, sigma), Pointwise(DoubleNear(1e-12 * std::max(count, 10)), line))
          << count << " " << sigma;
    }
  }
}

TEST(GaussianSmoothing, KeepsStraightLinesAroundMissingSamples) {
  std::vector<double> line = make_line(40, 5.0, -1.5);
  for (const int missing : {0, 1, 7, 8, 20, 39}) line[idx(missing)] = kNan;
  line[30] = kInfinity;
  const std::vector<double> result = smoothed(line, 3.0);
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (std::isnan(line[i])) {
      EXPECT_TRUE(std::isnan(result[i])) << i;
    } else if (std::isinf(line[i])) {
      EXPECT_EQ(result[i], line[i]);
    } else {
      EXPECT_NEAR(result[i], line[i], 1e-12) << i;
    }
  }
}

TEST(GaussianSmoothing, MissingSamplesAndTheirOppositesWeighNothing) {
  const std::vector<double> result = smoothed({0, 0, 9, kNan, 0}, 0.5);
  // Only the pair at distance 2 is left: 9 / (1 + 2 e^-8).
  EXPECT_NEAR(result[2], 8.99396572124777, 1e-12);
}

TEST(GaussianSmoothing, CurvesWithoutAFiniteSampleStay) {
  EXPECT_THAT(smoothed({kNan, kNan, kNan}, 2.0), Each(testing::IsNan()));
  EXPECT_THAT(smoothed({kInfinity}, 2.0), Each(kInfinity));
  EXPECT_THAT(smoothed({}, 2.0), testing::IsEmpty());
}

// The response to a single peak is the sampled Gaussian itself, cut at 4 sigma and divided by its sum.
TEST(GaussianSmoothing, ThePeakBecomesTheGaussian) {
  constexpr double kSigma = 2.0;
  std::vector<double> peak(41, 0.0);
  peak[20] = 1.0;
  double sum = 0.0;
  for (int k = -8; k <= 8; ++k) sum += std::exp(-k * k / (2 * kSigma * kSigma));
  const std::vector<double> result = smoothed(peak, kSigma);
  for (int i = 0; i < 41; ++i) {
    const int k = i - 20;
    const double expected = std::abs(k) <= 8 ? std::exp(-k * k / (2 * kSigma * kSigma)) / sum : 0.0;
    EXPECT_NEAR(result[idx(i)], expected, 1e-15) << i;
  }
}

// A sine keeps its shape and shrinks by the transfer function of a Gaussian, exp(-(omega sigma)^2 / 2).
TEST(GaussianSmoothing, ASineShrinksByTheTransferFunction) {
  constexpr double kSigma = 3.0;
  constexpr double kOmega = 0.2;
  std::vector<double> sine;
  for (int i = 0; i < 400; ++i) sine.push_back(std::sin(kOmega * i));
  const std::vector<double> result = smoothed(sine, kSigma);
  const double gain = std::exp(-0.5 * kOmega * kOmega * kSigma * kSigma);
  for (std::size_t i = 50; i < 350; ++i) EXPECT_NEAR(result[i], gain * sine[i], 1e-4);
}

TEST(GaussianSmoothing, IsLinearAndKnowsNoDirection) {
  Random random(4);
  std::vector<double> a(60);
  std::vector<double> reversed_a(60);
  for (std::size_t i = 0; i < a.size(); ++i) reversed_a[59 - i] = a[i] = random.between(-90, 90);
  const std::vector<double> forward = smoothed(a, 2.5);
  const std::vector<double> backward = smoothed(reversed_a, 2.5);
  for (double& value : a) value = 4.0 - 3.0 * value;
  const std::vector<double> mapped = smoothed(a, 2.5);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(backward[59 - i], forward[i], 1e-12);
    EXPECT_NEAR(mapped[i], 4.0 - 3.0 * forward[i], 1e-11);
  }
}

TEST(GaussianSmoothing, ARunIsPartOfTheSmoothedWhole) {
  Random random(5);
  std::vector<double> curve(700);
  for (double& value : curve) value = random.between(-90, 90);
  const std::vector<double> whole = smoothed(curve, 4.0);
  for (const FrameRange run : {FrameRange{0, 1}, {3, 300}, {255, 258}, {690, 10}, {100, 0}}) {
    std::vector<double> part(idx(run.count));
    compute_gaussian_smoothed(curve, run, 4.0, part);
    for (int i = 0; i < run.count; ++i) EXPECT_EQ(part[idx(i)], whole[idx(run.first + i)]);
  }
}

}  // namespace
}  // namespace marey::test
