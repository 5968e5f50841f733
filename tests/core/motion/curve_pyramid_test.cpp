#include "core/motion/curve_pyramid.h"
#include "tests/support/same_elements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace marey {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> random_samples(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-180.0, 180.0);
  std::vector<double> samples(idx(count));
  for (double& sample : samples) sample = value(random);
  return samples;
}

CurvePyramid pyramid_of(const std::vector<double>& samples) {
  CurvePyramid pyramid;
  pyramid.update(samples, {});
  return pyramid;
}

std::vector<ValueExtent> extents_of(const std::vector<double>& samples, const CurveColumns& columns) {
  std::vector<ValueExtent> extents(idx(columns.count));
  compute_column_extents(pyramid_of(samples), samples, columns, extents);
  return extents;
}

CurveColumns all_columns(double width, int sample_count) {
  return {width, 0, static_cast<int>(std::ceil(sample_count / width)) + 1};
}

ValueExtent extent_by_hand(std::span<const double> samples) {
  ValueExtent extent;
  for (const double sample : samples) extent.add(sample);
  return extent;
}

TEST(ValueExtent, KnowsNothingThenLowestAndHighestThenThatItIsBroken) {
  ValueExtent extent;
  EXPECT_TRUE(extent.empty());
  extent.add(3.0);
  extent.add(-2.0);
  EXPECT_EQ(extent, (ValueExtent{-2.0, 3.0}));
  EXPECT_FALSE(extent.empty());
  EXPECT_FALSE(extent.is_broken());
  for (const double bad : {kNan, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
    ValueExtent broken = extent;
    broken.add(bad);
    broken.add(1.0);
    EXPECT_TRUE(broken.is_broken()) << bad;
  }
}

TEST(CurvePyramid, EachBlockHoldsTheExtentOfItsSamples) {
  for (const int count : {0, 1, 15, 16, 17, 64, 65, 1000, 4097}) {
    const std::vector<double> samples = random_samples(count, static_cast<unsigned>(count));
    const CurvePyramid pyramid = pyramid_of(samples);
    EXPECT_EQ(pyramid.level_count() == 0, count == 0);
    for (int level = 0; level < pyramid.level_count(); ++level) {
      const int size = pyramid.block_size(level);
      const auto blocks = pyramid.blocks(level);
      ASSERT_EQ(size_of(blocks), (count + size - 1) / size);
      for (int block = 0; block < size_of(blocks); ++block) {
        const int first = block * size;
        const auto own = std::span(samples).subspan(idx(first), idx(std::min(size, count - first)));
        EXPECT_EQ(blocks[idx(block)], extent_by_hand(own)) << count << " samples, level " << level;
      }
    }
  }
}

TEST(CurvePyramid, AnEditRecomputesToTheSameAsAllAnew) {
  std::mt19937 random(7);
  std::vector<double> samples = random_samples(5000, 1);
  CurvePyramid pyramid = pyramid_of(samples);
  for (int edit = 0; edit < 200; ++edit) {
    const int first = std::uniform_int_distribution(0, 4999)(random);
    const int count = std::uniform_int_distribution(1, 5000 - first)(random) % 90 + 1;
    const FrameRange changed{first, std::min(count, 5000 - first)};
    for (int i = changed.first; i < changed.end(); ++i) samples[idx(i)] = edit % 7 == 0 ? kNan : 0.1 * edit - i;
    pyramid.update(samples, changed);
    const CurvePyramid anew = pyramid_of(samples);
    for (int level = 0; level < anew.level_count(); ++level) {
      ASSERT_TRUE(test::same_elements(pyramid.blocks(level), anew.blocks(level))) << "edit " << edit;
    }
  }
}

TEST(CurvePyramid, AnEditOfOneSampleReadsFewOthers) {
  std::vector<double> samples(100'000, 0.0);
  CurvePyramid pyramid = pyramid_of(samples);
  // What the update does not look at it cannot notice.
  std::fill(samples.begin(), samples.end(), 5.0);
  pyramid.update(samples, {50'000, 1});
  const auto blocks = pyramid.blocks(0);
  EXPECT_EQ(std::count_if(blocks.begin(), blocks.end(), [](const ValueExtent& b) { return b.high == 5.0; }), 1);
}

TEST(CurvePyramid, TakesASixthOfTheSamples) {
  const std::vector<double> samples(100'000, 0.0);
  EXPECT_LE(pyramid_of(samples).bytes() * 6, samples.size() * sizeof(double) + 6 * 16 * 16);
}

TEST(CurveColumns, TogetherHoldEachSampleOnce) {
  const std::vector<double> samples = random_samples(20'011, 3);
  const ValueExtent whole = extent_by_hand(samples);
  for (const double width : {1.0, 1.7, 2.0, 31.9, 32.0, 125.3, 511.9, 512.0, 3000.0, 50'000.0}) {
    ValueExtent together;
    for (const ValueExtent& column : extents_of(samples, all_columns(width, 20'011))) together.add(column);
    EXPECT_EQ(together, whole) << width;
  }
}

TEST(CurveColumns, HoldTheLastSamplesInTheColumnOfTheLast) {
  for (const int count : {1000, 1001, 1016, 4099}) {
    for (const double width : {33.0, 50.0, 64.0, 131.3}) {
      std::vector<double> samples(idx(count), 0.0);
      samples.back() = 9.0;
      const int last = static_cast<int>(std::floor((count - 1) / width));
      EXPECT_EQ(extents_of(samples, {width, 0, last + 1}).back().high, 9.0) << count << ", " << width;
      EXPECT_TRUE(extents_of(samples, {width, last + 1, 1}).back().empty()) << count << ", " << width;
    }
  }
}

TEST(CurveColumns, KeepAPeakWithinAQuarterOfAColumnOfItsPlace) {
  for (const double width : {2.5, 31.0, 40.0, 127.7, 700.0}) {
    for (const int peak : {0, 1, 777, 5000, 12'345, 19'999}) {
      std::vector<double> samples(20'000, 0.0);
      samples[idx(peak)] = 1.0;
      const auto extents = extents_of(samples, all_columns(width, 20'000));
      const auto found = std::find_if(extents.begin(), extents.end(), [](const ValueExtent& e) { return e.high == 1.0; });
      ASSERT_NE(found, extents.end()) << width << ", " << peak;
      const double place = static_cast<double>(found - extents.begin());
      EXPECT_GE(peak / width, place - 0.26) << width;
      EXPECT_LE(peak / width, place + 1.26) << width;
    }
  }
}

TEST(CurveColumns, AreTheSameWhereverTheViewBegins) {
  const std::vector<double> samples = random_samples(10'000, 5);
  for (const double width : {3.3, 77.7}) {
    const auto whole = extents_of(samples, all_columns(width, 10'000));
    const auto part = extents_of(samples, {width, 40, 50});
    EXPECT_TRUE(std::equal(part.begin(), part.end(), whole.begin() + 40)) << width;
  }
}

TEST(CurveColumns, AreBrokenByWhatIsNotFiniteAndEmptyBeyondTheSamples) {
  std::vector<double> samples(1000, 2.0);
  samples[500] = kNan;
  for (const double width : {2.0, 50.0}) {
    const auto extents = extents_of(samples, all_columns(width, 1000));
    EXPECT_EQ(std::count_if(extents.begin(), extents.end(), [](const ValueExtent& e) { return e.is_broken(); }), 1);
    EXPECT_TRUE(extents.back().empty());
    EXPECT_EQ(extents.front(), (ValueExtent{2.0, 2.0}));
  }
}

}  // namespace
}  // namespace marey
