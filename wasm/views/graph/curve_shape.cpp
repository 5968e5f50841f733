#include "wasm/views/graph/curve_shape.h"

#include <algorithm>
#include <cmath>

namespace marey::app {

void CurveShape::build(std::span<const double> samples, const TimeWindow& time, const ValueAxis& axis) {
  points_.clear();
  strips_.clear();
  open_ = false;
  if (samples.empty()) return;
  const double end = static_cast<double>(samples.size() - 1);
  const int first = static_cast<int>(std::clamp(std::floor(time.first), 0.0, end));
  const int last = static_cast<int>(std::clamp(std::ceil(time.last), 0.0, end));
  for (int frame = first; frame <= last; ++frame) {
    const double value = samples[static_cast<std::size_t>(frame)];
    if (std::isfinite(value)) {
      add_point({time.x_of(frame), axis.y_of(value)});
    } else {
      open_ = false;
    }
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

void CurveShape::draw(ImDrawList& list, ImU32 color, float width, Dashes dashes) const {
  for (const Strip& strip : strips_) stroke_dashed(list, points(strip), color, width, dashes);
}

void CurveShape::add_to(CurveBatch& batch, ImU32 color, float width) const {
  const float half = 0.5f * width;
  for (const Strip& strip : strips_) {
    for (const ImVec2& point : points(strip)) batch.places.push_back({point.x, point.y - half, point.y + half, color});
    batch.end_strip();
  }
}

}  // namespace marey::app
