#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "tests/app/support/imgui_stage.h"
#include "wasm/app/time_window.h"
#include "wasm/views/graph/curve_band.h"
#include "wasm/views/graph/curve_shape.h"
#include "wasm/views/graph/dashes.h"
#include "wasm/views/graph/ticks.h"
#include "wasm/views/graph/value_axis.h"

namespace marey::app {
namespace {

TimeWindow window_over(double first, double last, float width = 1000.0f) {
  TimeWindow time;
  time.first = first;
  time.last = last;
  time.left = 100.0f;
  time.right = 100.0f + width;
  return time;
}

ValueAxis axis_over(double low, double high) {
  ValueAxis axis;
  axis.low = low;
  axis.high = high;
  axis.top = 0.0f;
  axis.bottom = 200.0f;
  return axis;
}

CurveBand band_of(const std::vector<double>& samples, const TimeWindow& time, const ValueAxis& axis) {
  CurvePyramid pyramid;
  pyramid.update(samples, {});
  const CurveColumns columns = visible_columns(time, size_of(samples));
  std::vector<ValueExtent> extents(idx(columns.count));
  compute_column_extents(pyramid, samples, columns, extents);
  CurveBand band;
  band.build(extents, columns, time, axis);
  return band;
}

/// The strip's stretch of y at an x between its ends, as drawn.
std::pair<float, float> cut(const CurveBand& band, int strip, float x) {
  const auto columns = band.columns(band.strips()[idx(strip)]);
  for (std::size_t i = 1; i < columns.size(); ++i) {
    if (columns[i].x < x) continue;
    const float share = (x - columns[i - 1].x) / (columns[i].x - columns[i - 1].x);
    return {std::lerp(columns[i - 1].top, columns[i].top, share), std::lerp(columns[i - 1].bottom, columns[i].bottom, share)};
  }
  return {columns.back().top, columns.back().bottom};
}

TEST(Ticks, AreRoundAndWithinTheRange) {
  for (const double height : {1e-5, 0.37, 1.0, 42.0, 720.0, 3e6}) {
    const Ticks ticks = make_ticks(-0.4 * height, 0.6 * height, height / 9.0);
    ASSERT_GE(ticks.count, 3) << height;
    const double decade = std::pow(10.0, std::floor(std::log10(ticks.step) + 1e-9));
    const double factor = ticks.step / decade;
    EXPECT_TRUE(std::abs(factor - 1.0) < 1e-9 || std::abs(factor - 2.0) < 1e-9 || std::abs(factor - 5.0) < 1e-9);
    EXPECT_GE(ticks.at(0), -0.4 * height - 1e-12);
    EXPECT_LE(ticks.at(ticks.count - 1), 0.6 * height * (1.0 + 1e-12));
  }
}

TEST(Ticks, OfFramesAreWholeNumbers) {
  const Ticks ticks = make_ticks(1.0, 3.5, 0.01, true);
  EXPECT_EQ(ticks.step, 1.0);
  EXPECT_EQ(ticks.count, 3);
  EXPECT_EQ(ticks.decimals, 0);
}

TEST(Ticks, RefuseEmptyAndEndlessRanges) {
  EXPECT_EQ(make_ticks(1.0, 1.0, 0.1).count, 0);
  EXPECT_EQ(make_ticks(0.0, std::numeric_limits<double>::infinity(), 0.1).count, 0);
  EXPECT_EQ(make_ticks(0.0, 1.0, 0.0).count, 0);
}

TEST(Ticks, LabelsHaveNoNegativeZero) {
  EXPECT_EQ(tick_label(-0.0001, 1), "0.0");
  EXPECT_EQ(tick_label(-12.25, 2), "-12.25");
}

TEST(ValueAxis, PixelAndValueAreInverse) {
  const ValueAxis axis = axis_over(-30.0, 90.0);
  for (const double value : {-30.0, 0.0, 12.5, 90.0}) EXPECT_NEAR(axis.value_at(axis.y_of(value)), value, 1e-4);
  EXPECT_LT(axis.y_of(90.0), axis.y_of(-30.0));
}

TEST(ValueAxis, ZoomKeepsTheValueUnderThePointer) {
  ValueAxis axis = axis_over(-30.0, 90.0);
  const double before = axis.value_at(50.0f);
  axis.zoom(50.0f, 3.0);
  EXPECT_NEAR(axis.value_at(50.0f), before, 1e-9);
  EXPECT_NEAR(axis.high - axis.low, 360.0, 1e-9);
}

TEST(ValueAxis, FitGivesAFlatCurveAHeight) {
  ValueAxis axis = axis_over(0.0, 1.0);
  axis.fit(5.0, 5.0, 2.0);
  EXPECT_LT(axis.low, 5.0);
  EXPECT_GT(axis.high, 5.0);
}

TEST(ValueRange, SkipsWhatIsNotFinite) {
  ValueRange range;
  range.add(std::vector<double>{NAN, 3.0, -INFINITY, -1.0});
  EXPECT_FALSE(range.empty);
  EXPECT_EQ(range.low, -1.0);
  EXPECT_EQ(range.high, 3.0);
}

TEST(TimeWindow, ZoomKeepsTheFrameUnderThePointer) {
  TimeWindow time = window_over(0.0, 100.0);
  const double before = time.frame_at(400.0f);
  time.zoom(400.0f, 0.5, 101);
  EXPECT_NEAR(time.frame_at(400.0f), before, 1e-6);
  EXPECT_NEAR(time.last - time.first, 50.0, 1e-9);
}

TEST(TimeWindow, NeverLosesTheClip) {
  TimeWindow time = window_over(0.0, 100.0);
  for (int i = 0; i < 100; ++i) time.pan(77.0, 101);
  EXPECT_LE(time.first, 100.0);
  for (int i = 0; i < 100; ++i) time.pan(-77.0, 101);
  EXPECT_GE(time.last, 0.0);
  for (int i = 0; i < 100; ++i) time.zoom(300.0f, 2.0, 101);
  EXPECT_LE(time.last - time.first, 2.0 * 101 + 1e-9);
}

TEST(CurveShape, SparseSamplesAreDrawnOneByOne) {
  const std::vector<double> samples = {0.0, 1.0, 4.0, 2.0};
  CurveShape shape;
  shape.build(samples, window_over(0.0, 3.0), axis_over(0.0, 4.0));
  ASSERT_EQ(shape.strips().size(), 1u);
  const auto points = shape.points(shape.strips()[0]);
  ASSERT_EQ(points.size(), 4u);
  EXPECT_FLOAT_EQ(points[2].x, window_over(0.0, 3.0).x_of(2.0));
  EXPECT_FLOAT_EQ(points[2].y, 0.0f);
}

TEST(CurveShape, GapsBreakTheCurve) {
  const std::vector<double> samples = {0.0, 1.0, NAN, 2.0, 3.0};
  CurveShape shape;
  shape.build(samples, window_over(0.0, 4.0), axis_over(0.0, 4.0));
  ASSERT_EQ(shape.strips().size(), 2u);
  EXPECT_EQ(shape.strips()[0].count, 2);
  EXPECT_EQ(shape.strips()[1].count, 2);
}

TEST(CurveShape, DrawsOnlyWhatIsInSight) {
  const std::vector<double> samples(1000, 1.0);
  CurveShape shape;
  shape.build(samples, window_over(100.0, 110.0), axis_over(0.0, 2.0));
  ASSERT_EQ(shape.strips().size(), 1u);
  EXPECT_EQ(shape.strips()[0].count, 11);
  shape.build({}, window_over(0.0, 10.0), axis_over(0.0, 2.0));
  EXPECT_TRUE(shape.strips().empty());
}

// Of a zigzag line 120 long, whose corners are closer than the dashes: strokes of 6 with gaps of 3.
TEST(Dashes, GoOnAroundCorners) {
  const ImGuiStage stage;
  ImDrawList list(ImGui::GetDrawListSharedData());
  list._ResetForNewFrame();
  list.Flags = ImDrawListFlags_None;
  std::vector<ImVec2> points;
  for (int i = 0; i <= 30; ++i) points.push_back({2.4f * static_cast<float>(i), i % 2 == 0 ? 0.0f : 3.2f});
  const float dashes[] = {6.0f, 3.0f};
  stroke_dashed(list, points, IM_COL32_WHITE, 1.0f, dashes);
  // Without smoothing each stretch of a line is a quad, whose first two corners are as far apart as it is long.
  float drawn = 0.0f;
  for (int i = 0; i + 3 < list.VtxBuffer.Size; i += 4) {
    const ImVec2 a = list.VtxBuffer[i].pos;
    const ImVec2 b = list.VtxBuffer[i + 1].pos;
    drawn += std::hypot(b.x - a.x, b.y - a.y);
  }
  EXPECT_NEAR(drawn, 81.0f, 0.1f) << "13 strokes of 6 and one of 3";
}

TEST(CurveBand, KeepsEveryPeakAtTheCostOfPixels) {
  std::vector<double> samples(100000, 0.0);
  samples[51234] = 7.0;
  const ValueAxis axis = axis_over(0.0, 7.0);
  const TimeWindow time = window_over(0.0, 99999.0);
  const CurveBand band = band_of(samples, time, axis);
  ASSERT_EQ(band.strips().size(), 1u);
  const auto columns = band.columns(band.strips()[0]);
  EXPECT_LE(columns.size(), 1001u);
  const auto highest = std::min_element(columns.begin(), columns.end(), [](auto& a, auto& b) { return a.top < b.top; });
  EXPECT_FLOAT_EQ(highest->top, axis.y_of(7.0));
  EXPECT_FLOAT_EQ(highest->bottom, axis.y_of(0.0));
  EXPECT_NEAR(highest->x, time.x_of(51234), 1.0f);
}

TEST(CurveBand, CoversEachSample) {
  std::vector<double> samples(5000);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = std::sin(0.01 * static_cast<double>(i)) * 40.0 + static_cast<double>(i % 3);
  const TimeWindow time = window_over(0.0, 4999.0);
  const ValueAxis axis = axis_over(-50.0, 50.0);
  const CurveBand band = band_of(samples, time, axis);
  for (int frame = 0; frame < 5000; ++frame) {
    const float x = time.x_of(frame);
    const float y = axis.y_of(samples[idx(frame)]);
    const auto [top, bottom] = cut(band, 0, x);
    EXPECT_GE(y, top - 1.5f) << frame;
    EXPECT_LE(y, bottom + 1.5f) << frame;
  }
}

TEST(CurveBand, AStepIsBridged) {
  std::vector<double> samples(3000, 0.0);
  std::fill(samples.begin() + 1500, samples.end(), 100.0);
  const CurveBand band = band_of(samples, window_over(0.0, 2999.0), axis_over(0.0, 100.0));
  ASSERT_EQ(band.strips().size(), 1u);
  const auto columns = band.columns(band.strips()[0]);
  for (std::size_t i = 1; i < columns.size(); ++i) {
    EXPECT_LE(columns[i].top, columns[i - 1].bottom + 1e-3f);
    EXPECT_GE(columns[i].bottom, columns[i - 1].top - 1e-3f);
  }
}

TEST(CurveBand, IsBrokenByWhatIsNotFinite) {
  std::vector<double> samples(10000, 1.0);
  samples[5000] = NAN;
  const CurveBand band = band_of(samples, window_over(0.0, 9999.0), axis_over(0.0, 2.0));
  ASSERT_EQ(band.strips().size(), 2u);
  EXPECT_LE(band.columns(band.strips()[0]).back().x, window_over(0.0, 9999.0).x_of(5000));
}

TEST(CurveBand, DoesNotChangeWhenPanned) {
  std::vector<double> samples(100000);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = std::sin(12.9898 * static_cast<double>(i));
  const ValueAxis axis = axis_over(-1.0, 1.0);
  TimeWindow time = window_over(20000.0, 60000.0);
  const CurveBand before = band_of(samples, time, axis);
  const CurveColumns columns = visible_columns(time, 100000);
  time.pan(7.0 * columns.frames_per_column, 100000);
  const CurveBand after = band_of(samples, time, axis);
  const auto old = before.columns(before.strips()[0]);
  const auto moved = after.columns(after.strips()[0]);
  // The ends apart, whose neighbours are out of sight.
  for (std::size_t i = 10; i + 10 < moved.size(); ++i) {
    EXPECT_FLOAT_EQ(moved[i].top, old[i + 7].top);
    EXPECT_NEAR(moved[i].x, old[i + 7].x - 7.0f, 1e-2f);
  }
}

TEST(CurveBand, IsNothingWhereThereIsNothing) {
  EXPECT_EQ(visible_columns(window_over(10.0, 500.0), 0).count, 0);
  EXPECT_EQ(visible_columns(window_over(10.0, 500.0), 5).count, 0);
  EXPECT_TRUE(band_of({}, window_over(0.0, 500.0), axis_over(0.0, 1.0)).strips().empty());
}

}  // namespace
}  // namespace marey::app
