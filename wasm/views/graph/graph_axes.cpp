#include "wasm/views/graph/graph_axes.h"

#include <cmath>
#include <string>

#include "wasm/app/small_text.h"
#include "wasm/views/graph/ticks.h"

namespace marey::app {
namespace {

constexpr float kFrameSpacing = 72.0f;
constexpr float kLabelGap = 6.0f;

Ticks value_ticks(const ValueAxis& axis, float spacing) {
  return make_ticks(axis.low, axis.high, axis.values_per_unit() * static_cast<double>(spacing));
}

}  // namespace

Ticks frame_ticks(const TimeWindow& time) {
  // People count frames from 1, so the round numbers are those of frame + 1.
  const double least_step = time.frames_per_unit() * static_cast<double>(kFrameSpacing);
  return make_ticks(time.first + 1.0, time.last + 1.0, least_step, true);
}

void draw_value_grid(ImDrawList& list, const GraphArea& area, const ValueAxis& axis, const Theme& theme, float spacing) {
  const Ticks ticks = value_ticks(axis, spacing);
  for (int i = 0; i < ticks.count; ++i) {
    const double value = ticks.at(i);
    const bool zero = std::abs(value) < 0.5 * ticks.step;
    const float y = std::round(axis.y_of(value));
    list.AddLine({area.min.x, y}, {area.max.x, y}, with_alpha(theme.line, zero ? 1.0f : 0.5f), 1.0f);
  }
}

void draw_value_labels(ImDrawList& list, const GraphArea& area, const ValueAxis& axis, AxisSide side,
                       std::string_view unit, const Theme& theme, const Fonts& fonts, float spacing) {
  const Ticks ticks = value_ticks(axis, spacing);
  const float size = Fonts::kSmallSize;
  const auto place = [&](const SmallText& text, float y) {
    const float width = fonts.mono->CalcTextSizeA(size, FLT_MAX, 0.0f, text.c_str()).x;
    const float x = side == AxisSide::Left ? area.min.x - kLabelGap - width : area.max.x + kLabelGap;
    list.AddText(fonts.mono, size, {std::round(x), std::round(y)}, theme.dim_text, text.c_str());
  };
  // A degree sign fits behind each number; a word stands once, at the top.
  const bool short_unit = unit == "°" || unit.empty();
  const float first_free_y = area.min.y + (short_unit ? 0.0f : 1.5f * size);
  if (!short_unit) place(SmallText("{}", unit), area.min.y + 1.0f);
  for (int i = 0; i < ticks.count; ++i) {
    const float y = axis.y_of(ticks.at(i)) - 0.5f * size - 1.0f;
    if (y < first_free_y || y > area.max.y - size) continue;
    place(SmallText("{}{}", tick_label(ticks.at(i), ticks.decimals), short_unit ? unit : std::string_view()), y);
  }
}

void draw_frame_grid(ImDrawList& list, const GraphArea& area, const TimeWindow& time, const Theme& theme) {
  const Ticks ticks = frame_ticks(time);
  for (int i = 0; i < ticks.count; ++i) {
    const float x = std::round(time.x_of(ticks.at(i) - 1.0));
    if (x < area.min.x || x > area.max.x) continue;
    list.AddLine({x, area.min.y}, {x, area.max.y}, with_alpha(theme.line, 0.5f), 1.0f);
  }
}

}  // namespace marey::app
