#include "wasm/views/graph/curve_band.h"

#include <algorithm>
#include <cmath>

namespace marey::app {
namespace {

// Where the curve goes on above or below a column, both columns reach into the gap by this share: less would make
// steep stretches thinner than level ones, more thicker.
constexpr float kBridge = 0.65f;
constexpr float kHalfColumn = 0.5f;

/// Screen y of values, as ValueAxis::y_of().
class ScreenY {
 public:
  explicit ScreenY(const ValueAxis& axis)
      : height_(static_cast<double>(axis.bottom - axis.top)),
        scale_(height_ / (axis.high - axis.low)),
        offset_(static_cast<double>(axis.bottom) + axis.low * scale_),
        highest_(static_cast<double>(axis.bottom) - 1e3 * height_),
        lowest_(static_cast<double>(axis.bottom) + 1e3 * height_) {}

  [[nodiscard]] float operator()(double value) const {
    return static_cast<float>(std::min(std::max(offset_ - value * scale_, highest_), lowest_));
  }

 private:
  double height_, scale_, offset_, highest_, lowest_;
};

}  // namespace

CurveColumns visible_columns(const TimeWindow& time, int sample_count) {
  CurveColumns columns;
  columns.frames_per_column = time.frames_per_unit();
  const double last = std::min(time.last, sample_count - 1.0);
  const double first = std::max(time.first, 0.0);
  if (last < first) return columns;
  columns.first = static_cast<int>(std::floor(first / columns.frames_per_column));
  columns.count = static_cast<int>(std::floor(last / columns.frames_per_column)) - columns.first + 1;
  return columns;
}

std::span<const CurveBand::Column> CurveBand::columns(const Strip& strip) const {
  return std::span(columns_).subspan(idx(strip.first), idx(strip.count));
}

void CurveBand::add_column(const Column& column) {
  if (!open_) strips_.push_back({size_of(columns_), 0});
  open_ = true;
  columns_.push_back(column);
  ++strips_.back().count;
}

void CurveBand::build(std::span<const ValueExtent> extents, const CurveColumns& columns, const TimeWindow& time,
                      const ValueAxis& axis) {
  columns_.clear();
  strips_.clear();
  open_ = false;
  const ScreenY y_of(axis);
  const double width = columns.frames_per_column;
  for (int i = 0; i < columns.count; ++i) {
    const ValueExtent& extent = extents[idx(i)];
    if (extent.empty() || extent.is_broken()) {
      open_ = false;
      continue;
    }
    const float x = time.x_of((columns.first + i + 0.5) * width - 0.5);
    add_column({x, y_of(extent.high), y_of(extent.low)});
  }
  bridge_gaps();
}

void CurveBand::bridge_gaps() {
  for (const Strip& strip : strips_) {
    const std::span<Column> all = std::span(columns_).subspan(idx(strip.first), idx(strip.count));
    Column before = all.front();
    for (std::size_t i = 1; i < all.size(); ++i) {
      const Column here = all[i];
      const float fall = here.top - before.bottom;
      const float rise = before.top - here.bottom;
      if (fall > 0.0f) {
        all[i - 1].bottom = std::max(all[i - 1].bottom, before.bottom + kBridge * fall);
        all[i].top = here.top - kBridge * fall;
      } else if (rise > 0.0f) {
        all[i - 1].top = std::min(all[i - 1].top, before.top - kBridge * rise);
        all[i].bottom = here.bottom + kBridge * rise;
      }
      before = here;
    }
  }
}

void CurveBand::draw_middle(ImDrawList& list, ImU32 color, float width, Dashes dashes) {
  for (const Strip& strip : strips_) {
    middles_.clear();
    for (const Column& column : columns(strip)) middles_.push_back({column.x, 0.5f * (column.top + column.bottom)});
    stroke_dashed(list, middles_, color, width, dashes);
  }
}

void CurveBand::add_to(CurveBatch& batch, ImU32 color, float width) const {
  const float half = 0.5f * width;
  const auto add = [&](const Column& column, float shift) {
    batch.places.push_back({column.x + shift, column.top - half, column.bottom + half, color});
  };
  for (const Strip& strip : strips_) {
    const std::span<const Column> all = columns(strip);
    add(all.front(), -kHalfColumn);
    for (const Column& column : all) add(column, 0.0f);
    add(all.back(), kHalfColumn);
    batch.end_strip();
  }
}

}  // namespace marey::app
