#pragma once

#include <imgui.h>

#include <span>
#include <string_view>

#include "wasm/app/view_context.h"
#include "wasm/views/graph/dashes.h"

namespace marey::app {

/// A curve of a small plot; values that are not finite break it.
struct PlotCurve {
  std::span<const double> x;
  std::span<const double> y;
  ImU32 color = 0;
  float width = 1.5f;
  Dashes dashes{};
};

/// An upright line with its name.
struct PlotMark {
  double x = 0.0;
  ImU32 color = 0;
  std::string_view name;
};

/// A place on a curve.
struct PlotDot {
  double x = 0.0;
  double y = 0.0;
  ImU32 color = 0;
};

/// A stretch of x that is shaded.
struct PlotStretch {
  double from = 0.0;
  double to = 0.0;
  ImU32 color = 0;
};

struct SmallPlot {
  std::string_view title;
  std::string_view x_unit;
  std::string_view y_unit;
  double x_low = 0.0;
  double x_high = 1.0;
  std::span<const PlotCurve> curves;
  std::span<const PlotMark> marks;
  std::span<const PlotStretch> stretches;
  bool from_zero = false;  ///< the value axis starts at 0
  std::span<const PlotDot> dots{};
  double least_height = 1e-9;  ///< of the value axis: less is rounding
};

/// Draws a plot with title, axes and units into a rectangle; curves with more points than pixels by their extents.
void draw_small_plot(ViewContext& context, const char* id, ImVec2 min, ImVec2 max, const SmallPlot& plot);

/// The rectangle (left, top, right, bottom) of one of `count` plots side by side, in as few rows as keep each at least
/// `least_width` wide, the rows as even as can be.
[[nodiscard]] ImVec4 plot_place(int index, int count, ImVec2 min, ImVec2 max, float least_width);

}  // namespace marey::app
