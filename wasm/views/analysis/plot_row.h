#pragma once

#include <imgui.h>

#include <cstdint>
#include <span>
#include <vector>

#include "core/motion/curve_pyramid.h"
#include "wasm/app/analysis.h"
#include "wasm/app/view_context.h"
#include "wasm/render/curve_batch.h"
#include "wasm/views/graph/curve_band.h"
#include "wasm/views/graph/curve_shape.h"
#include "wasm/views/graph/graph_axes.h"

namespace marey::app {

/// One quantity over time, on the frames of the ruler above. Keeps what is drawn as long as nothing of it changes.
class PlotRow {
 public:
  /// The rectangle of the row; the plot stands on the right of `context.time_window.left`.
  void draw(ViewContext& context, const AnalysisPlot& plot, std::uint64_t serial, int index, ImVec2 min, ImVec2 max);

 private:
  struct Look {
    std::uint64_t serial = 0;
    TimeWindow time;
    ValueAxis axis;
    ImU32 colors[5] = {};
    float width = 0.0f;
    bool operator==(const Look&) const = default;
  };
  void follow(const AnalysisPlot& plot, std::uint64_t serial);
  void draw_ground(ViewContext& context, const AnalysisPlot& plot) const;
  void draw_bands(ViewContext& context, const AnalysisPlot& plot) const;
  void draw_lines(ViewContext& context, const AnalysisPlot& plot);
  void add_line(ViewContext& context, const PlotLine& line, std::size_t number, ImU32 color, float width);
  void build_band(const ViewContext& context, const PlotLine& line, std::size_t number);
  void draw_others(ViewContext& context, const AnalysisPlot& plot);
  void draw_ends(ViewContext& context, const AnalysisPlot& plot) const;
  void draw_cursor(ViewContext& context, const AnalysisPlot& plot) const;
  void handle_input(ViewContext& context, const AnalysisPlot& plot, int index) const;

  GraphArea area_;
  ValueAxis axis_;
  ValueRange range_;
  std::uint64_t serial_ = 0;
  std::vector<CurvePyramid> pyramids_;  // of lines, raw lines and those of other clips, in this order
  std::vector<ValueExtent> extents_;
  CurveColumns columns_;
  bool dense_ = false;
  CurveShape shape_;
  CurveBand band_;
  CurveBatch batch_;
  Look look_;
};

/// Of the value axis of a plot, in any unit: less is rounding.
inline constexpr double kLeastHeight = 1e-3;

/// Of a component; the accent where there is none.
[[nodiscard]] ImU32 component_color(const Theme& theme, char component);

/// How the lines of a clip beside the open one are dashed, so that at most kMostOtherClips are told apart.
[[nodiscard]] Dashes dashes_of(std::size_t other);

/// Of what is hovered: the wheel zooms in time, with Shift and sideways it pans.
void zoom_by_wheel(ViewContext& context);

/// "12.34": as many decimals as three to four digits need.
[[nodiscard]] SmallText value_text(double value);

}  // namespace marey::app
