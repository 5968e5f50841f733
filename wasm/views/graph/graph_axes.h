#pragma once

#include <imgui.h>

#include <string_view>

#include "wasm/app/fonts.h"
#include "wasm/app/theme.h"
#include "wasm/app/time_window.h"
#include "wasm/views/graph/ticks.h"
#include "wasm/views/graph/value_axis.h"

namespace marey::app {

/// Screen rectangle of the plotted area.
struct GraphArea {
  ImVec2 min;
  ImVec2 max;

  [[nodiscard]] bool contains(ImVec2 point) const {
    return point.x >= min.x && point.x < max.x && point.y >= min.y && point.y < max.y;
  }
};

enum class AxisSide { Left, Right };

/// Least distance of the numbers of a value axis, in ImGui units.
inline constexpr float kValueSpacing = 36.0f;

/// Grid lines of a value axis across the area; zero stands out.
void draw_value_grid(ImDrawList& list, const GraphArea& area, const ValueAxis& axis, const Theme& theme,
                     float spacing = kValueSpacing);

/// Numbers of a value axis in its gutter with the unit at the top; without one where it stands elsewhere.
void draw_value_labels(ImDrawList& list, const GraphArea& area, const ValueAxis& axis, AxisSide side,
                       std::string_view unit, const Theme& theme, const Fonts& fonts,
                       float spacing = kValueSpacing);

/// Vertical lines at round frames, in step with the ruler.
void draw_frame_grid(ImDrawList& list, const GraphArea& area, const TimeWindow& time, const Theme& theme);

/// Ticks of the frame axis: distance in frames between labelled marks.
[[nodiscard]] Ticks frame_ticks(const TimeWindow& time);

}  // namespace marey::app
