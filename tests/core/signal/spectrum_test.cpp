#include "core/signal/spectrum.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/signal/derivative.h"
#include "tests/core/signal/curves.h"

namespace marey::test {
namespace {

TEST(Spectrum, ASineHasOnePeakOfItsAmplitude) {
  std::vector<double> curve = make_line(1024, 30.0, 0.2);
  for (int i = 0; i < 1024; ++i) curve[static_cast<std::size_t>(i)] += 4.0 * std::sin(2.0 * std::numbers::pi * 32.0 * i / 1024.0);
  const Spectrum spectrum = compute_spectrum(curve, 128.0);
  EXPECT_DOUBLE_EQ(spectrum.step_hz, 0.125);
  ASSERT_EQ(spectrum.amplitudes.size(), 513u);
  const auto peak = std::max_element(spectrum.amplitudes.begin(), spectrum.amplitudes.end());
  EXPECT_EQ(peak - spectrum.amplitudes.begin(), 32);
  EXPECT_NEAR(*peak, 4.0, 0.01);
  EXPECT_LT(spectrum.amplitudes[40], 0.01);
}

TEST(Spectrum, OfALineIsNothing) {
  for (const double amplitude : compute_spectrum(make_line(300, -4.0, 1.5), 30).amplitudes) EXPECT_LT(amplitude, 1e-9);
  for (const int count : {0, 1, 2, 3}) EXPECT_TRUE(compute_spectrum(make_line(count, 1, 1), 30).amplitudes.empty());
}

TEST(Derivatives, OfAParabolaAreExact) {
  std::vector<double> curve;
  for (int i = 0; i < 20; ++i) curve.push_back(3.0 - 2.0 * i + 0.5 * i * i);
  std::vector<double> first(20);
  std::vector<double> second(20);
  compute_first_derivative(curve, 10.0, first);
  compute_second_derivative(curve, 10.0, second);
  for (int i = 0; i < 20; ++i) {
    EXPECT_NEAR(first[static_cast<std::size_t>(i)], 10.0 * (i - 2.0), 1e-9);
    EXPECT_NEAR(second[static_cast<std::size_t>(i)], 100.0, 1e-9);
  }
}

TEST(Derivatives, OfShortCurvesAreThere) {
  for (const int count : {0, 1, 2, 3}) {
    const std::vector<double> line = make_line(count, 1.0, 2.0);
    std::vector<double> result(line.size());
    compute_first_derivative(line, 1.0, result);
    for (const double value : result) EXPECT_EQ(value, count == 1 ? 0.0 : 2.0);
    compute_second_derivative(line, 1.0, result);
    for (const double value : result) EXPECT_EQ(value, 0.0);
  }
}

}  // namespace
}  // namespace marey::test
