#include "wasm/views/graph/curve_shape.h"

#include <algorithm>
#include <cmath>

namespace marey::app {
namespace {

// From this many samples in a column on, extremes say more than samples.
constexpr double kDenseSamplesPerColumn = 2.0;

}  // namespace

void CurveShape::build(std::span<const double> samples, const TimeWindow& time, const ValueAxis& axis,
                       float column_width) {
  points_.clear();
  strips_.clear();
  open_ = false;
  if (samples.empty()) return;
  const double end = static_cast<double>(samples.size() - 1);
  const int first = static_cast<int>(std::clamp(std::floor(time.first), 0.0, end));
  const int last = static_cast<int>(std::clamp(std::ceil(time.last), 0.0, end));
  const double frames_per_column = time.frames_per_unit() * static_cast<double>(column_width);
  if (frames_per_column < kDenseSamplesPerColumn) {
    add_samples(samples, first, last, time, axis);
  } else {
    add_columns(samples, first, last, time, axis, frames_per_column);
  }
}

std::span<const ImVec2> CurveShape::points(const Strip& strip) const {
  return std::span(points_).subspan(static_cast<std::size_t>(strip.first), static_cast<std::size_t>(strip.count));
}

void CurveShape::add_point(ImVec2 point) {
  if (!open_) strips_.push_back({static_cast<int>(points_.size()), 0});
  open_ = true;
  points_.push_back(point);
  ++strips_.back().count;
}

void CurveShape::break_strip() { open_ = false; }

void CurveShape::add_samples(std::span<const double> samples, int first, int last, const TimeWindow& time,
                             const ValueAxis& axis) {
  for (int frame = first; frame <= last; ++frame) {
    const double value = samples[static_cast<std::size_t>(frame)];
    if (std::isfinite(value)) {
      add_point({time.x_of(frame), axis.y_of(value)});
    } else {
      break_strip();
    }
  }
}

void CurveShape::add_columns(std::span<const double> samples, int first, int last, const TimeWindow& time,
                             const ValueAxis& axis, double frames_per_column) {
  // Columns start at multiples of their width, so that a curve does not shimmer while it is panned.
  double column_end = (std::floor(first / frames_per_column) + 1.0) * frames_per_column;
  int frame = first;
  while (frame <= last) {
    const int end = std::clamp(static_cast<int>(std::ceil(column_end)), frame + 1, last + 1);
    const auto column = samples.subspan(static_cast<std::size_t>(frame), static_cast<std::size_t>(end - frame));
    if (std::all_of(column.begin(), column.end(), [](double v) { return std::isfinite(v); })) {
      const auto [low, high] = std::minmax_element(column.begin(), column.end());
      const float x = time.x_of(frame);
      add_point({x, axis.y_of(column.front())});
      add_point({x, axis.y_of(low < high ? *low : *high)});
      add_point({x, axis.y_of(low < high ? *high : *low)});
      add_point({time.x_of(end - 1), axis.y_of(column.back())});
    } else {
      break_strip();
    }
    frame = end;
    column_end += frames_per_column;
  }
}

}  // namespace marey::app
