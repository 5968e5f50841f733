#include "core/signal/median.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/signal/gaps.h"
#include "tests/core/signal/curves.h"
#include "tests/support/random.h"

namespace marey::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> median(const std::vector<double>& curve, int window) {
  std::vector<double> result(curve.size());
  compute_median(curve, window, result);
  return result;
}

TEST(Median, KeepsWhatOnlyRisesToTheBit) {
  Random random(7);
  for (const int count : {0, 1, 2, 3, 40}) {
    std::vector<double> rising(static_cast<std::size_t>(count));
    for (double& value : rising) value = random.between(-90, 90);
    std::sort(rising.begin(), rising.end());
    for (const int window : {1, 3, 5, 101}) EXPECT_EQ(median(rising, window), rising);
  }
}

TEST(Median, IsTheMiddleOfEachWindow) {
  Random random(8);
  std::vector<double> curve(200);
  for (double& value : curve) value = random.between(-90, 90);
  for (const int window : {3, 5, 21}) {
    const std::vector<double> result = median(curve, window);
    for (int i = 0; i < 200; ++i) {
      const int reach = std::min({window / 2, i, 199 - i});
      std::vector<double> part(curve.begin() + i - reach, curve.begin() + i + reach + 1);
      std::nth_element(part.begin(), part.begin() + reach, part.end());
      ASSERT_EQ(result[idx(i)], part[idx(reach)]);
    }
  }
}

TEST(Median, MissingSamplesStayAndDoNotCount) {
  const std::vector<double> result = median({1, kNan, 5, 2, 9, 4, 3}, 5);
  EXPECT_TRUE(std::isnan(result[1]));
  EXPECT_THAT(std::vector<double>(result.begin() + 2, result.begin() + 5), ElementsAre(3.5, 4.5, 4));
}

TEST(Spikes, AreShortAndStandOut) {
  std::vector<double> curve;
  for (int i = 0; i < 200; ++i) curve.push_back(20.0 * std::sin(0.1 * i));
  EXPECT_THAT(find_spikes(curve, {}), IsEmpty());
  curve[50] += 40.0;
  curve[120] -= 60.0;
  curve[121] -= 55.0;
  EXPECT_THAT(find_spikes(curve, {.most_frames = 3}), ElementsAre(FrameRange{50, 1}, FrameRange{120, 2}));
  EXPECT_THAT(find_spikes(curve, {.most_frames = 3, .least_height = 50.0}), ElementsAre(FrameRange{120, 2}));
}

TEST(Spikes, StepsAndTurnsAreNone) {
  std::vector<double> step(40, 0.0);
  step.resize(80, 50.0);
  EXPECT_THAT(find_spikes(step, {}), IsEmpty());
  EXPECT_THAT(find_spikes(std::vector<double>(5, kNan), {}), IsEmpty());
  for (const int count : {0, 1, 2}) EXPECT_THAT(find_spikes(make_line(count, 1, 5), {}), IsEmpty());
}

TEST(Gaps, AreRunsOfWhatIsNotFinite) {
  EXPECT_THAT(find_gaps(std::vector<double>{kNan, 1, 2, kNan, std::numeric_limits<double>::infinity(), 3}),
              ElementsAre(FrameRange{0, 1}, FrameRange{3, 2}));
  EXPECT_THAT(find_gaps(std::vector<double>{}), IsEmpty());
}

TEST(Gaps, AreAlsoWhatStandsStillWhereThatIsAsked) {
  const std::vector<double> curve = {1, 1, 2, 3, 3, 3, 3, kNan, 4, 4, 4, 4};
  EXPECT_THAT(find_gaps(curve), ElementsAre(FrameRange{7, 1}));
  EXPECT_THAT(find_gaps(curve, 3), ElementsAre(FrameRange{4, 4}, FrameRange{9, 3}));
  EXPECT_THAT(find_gaps(curve, 4), ElementsAre(FrameRange{7, 1}));
  EXPECT_THAT(find_gaps(curve, 1), ElementsAre(FrameRange{1, 1}, FrameRange{4, 4}, FrameRange{9, 3}));
}

TEST(Gaps, AreFilledByLinesAndCubics) {
  const auto cubic = [](double x) { return 2.0 - 0.5 * x + 0.3 * x * x - 0.01 * x * x * x; };
  std::vector<double> curve;
  for (int i = 0; i < 30; ++i) curve.push_back(cubic(i));
  const std::vector<double> whole = curve;
  for (const int missing : {4, 5, 6, 12, 20, 21}) curve[idx(missing)] = kNan;
  std::vector<double> filled = curve;
  fill_gaps(filled, find_gaps(filled), GapFill::Cubic);
  for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_NEAR(filled[i], whole[i], 1e-9);
  fill_gaps(curve, find_gaps(curve), GapFill::Linear);
  EXPECT_NEAR(curve[5], 0.5 * (whole[3] + whole[7]), 1e-12);
}

TEST(Gaps, AtTheEndsHoldTheNeighbour) {
  std::vector<double> curve = {kNan, kNan, 3, 4, kNan};
  fill_gaps(curve, find_gaps(curve), GapFill::Cubic);
  EXPECT_THAT(curve, ElementsAre(3, 3, 3, 4, 4));
  std::vector<double> nothing = {kNan, kNan};
  fill_gaps(nothing, find_gaps(nothing), GapFill::Linear);
  EXPECT_THAT(nothing, testing::Each(testing::IsNan()));
}

}  // namespace
}  // namespace marey::test
