#include "wasm/views/graph/small_plot.h"

#include <algorithm>
#include <cmath>

#include "wasm/views/graph/ticks.h"
#include "wasm/views/graph/value_axis.h"

namespace marey::app {
namespace {

constexpr float kTitleHeight = 20.0f;
constexpr float kLeft = 44.0f;
constexpr float kBottom = 18.0f;
constexpr float kGap = 8.0f;
constexpr float kTickSpacing = 28.0f;
constexpr float kXTickSpacing = 56.0f;

/// Where a plot's values stand on the screen.
struct PlotArea {
  ImVec2 min;
  ImVec2 max;
  double x_low = 0.0;
  double x_high = 1.0;
  ValueAxis axis;

  [[nodiscard]] float x_of(double x) const {
    const double share = x_high > x_low ? (x - x_low) / (x_high - x_low) : 0.0;
    return min.x + static_cast<float>(share) * (max.x - min.x);
  }
};

PlotArea place(const SmallPlot& plot, ImVec2 min, ImVec2 max) {
  PlotArea area{{min.x + kLeft, min.y + kTitleHeight}, {max.x - kGap, max.y - kBottom}, plot.x_low, plot.x_high, {}};
  ValueRange range;
  for (const PlotCurve& curve : plot.curves) {
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (curve.x[i] >= plot.x_low && curve.x[i] <= plot.x_high) range.add(curve.y[i]);
    }
  }
  if (!range.empty) area.axis.fit(plot.from_zero ? 0.0 : range.low, range.high, std::max(plot.least_height, 1e-6 * std::abs(range.high)));
  if (plot.from_zero) area.axis.low = 0.0;
  area.axis.top = area.min.y;
  area.axis.bottom = area.max.y;
  return area;
}

void draw_axes(ViewContext& context, const SmallPlot& plot, const PlotArea& area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Theme& theme = context.theme;
  const float size = Fonts::kSmallSize;
  const Ticks values = make_ticks(area.axis.low, area.axis.high, area.axis.values_per_unit() * static_cast<double>(kTickSpacing));
  for (int i = 0; i < values.count; ++i) {
    const float y = std::round(area.axis.y_of(values.at(i)));
    const SmallText text("{}", tick_label(values.at(i), values.decimals));
    const float width = context.fonts.mono->CalcTextSizeA(size, FLT_MAX, 0.0f, text.c_str()).x;
    list.AddLine({area.min.x, y}, {area.max.x, y}, with_alpha(theme.line, 0.6f));
    list.AddText(context.fonts.mono, size, {std::round(area.min.x - 4.0f - width), std::round(y - 0.5f * size - 1.0f)},
                 theme.dim_text, text.c_str());
  }
  const double per_unit = (plot.x_high - plot.x_low) / static_cast<double>(std::max(area.max.x - area.min.x, 1.0f));
  const Ticks times = make_ticks(plot.x_low, plot.x_high, per_unit * static_cast<double>(kXTickSpacing));
  const SmallText unit("{}", plot.x_unit);
  const float unit_width = context.fonts.mono->CalcTextSizeA(size, FLT_MAX, 0.0f, unit.c_str()).x;
  for (int i = 0; i < times.count; ++i) {
    const float x = std::round(area.x_of(times.at(i)));
    const SmallText text("{}", tick_label(times.at(i), times.decimals));
    const float width = context.fonts.mono->CalcTextSizeA(size, FLT_MAX, 0.0f, text.c_str()).x;
    list.AddLine({x, area.min.y}, {x, area.max.y}, with_alpha(theme.line, 0.4f));
    if (x + 0.5f * width > area.max.x - unit_width - 6.0f) continue;
    list.AddText(context.fonts.mono, size, {std::round(x - 0.5f * width), area.max.y + 3.0f}, theme.dim_text, text.c_str());
  }
  list.AddText(context.fonts.mono, size, {area.max.x - unit_width, area.max.y + 3.0f}, theme.dim_text, unit.c_str());
}

/// The points of a curve within one column of pixels: the first, the lowest, the highest and the last, in their order.
struct ColumnPoints {
  int column = 0;
  int count = 0;
  int low_at = 0;
  int high_at = 0;
  float first = 0.0f;
  float low = 0.0f;
  float high = 0.0f;
  float last = 0.0f;

  void add(float y) {
    if (count == 0) first = low = high = y;
    if (y > low) {
      low = y;
      low_at = count;
    }
    if (y < high) {
      high = y;
      high_at = count;
    }
    last = y;
    ++count;
  }
  void draw(ImDrawList& list, float x) const {
    list.PathLineTo({x, first});
    if (count < 2) return;
    list.PathLineTo({x, low_at < high_at ? low : high});
    list.PathLineTo({x, low_at < high_at ? high : low});
    list.PathLineTo({x, last});
  }
};

// As many points to a pixel as there are become the extent of that pixel.
void draw_curve(const PlotCurve& curve, const PlotArea& area) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PathClear();
  ColumnPoints column;
  float x_first = 0.0f;
  const auto close_column = [&] {
    if (column.count > 0) column.draw(list, x_first);
    column = {};
  };
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (!std::isfinite(curve.x[i]) || !std::isfinite(curve.y[i])) {
      close_column();
      stroke_path(list, curve.color, curve.width, curve.dashes);
      continue;
    }
    const float x = area.x_of(curve.x[i]);
    if (column.count > 0 && static_cast<int>(x) != column.column) close_column();
    if (column.count == 0) {
      column.column = static_cast<int>(x);
      x_first = x;
    }
    column.add(area.axis.y_of(curve.y[i]));
  }
  close_column();
  stroke_path(list, curve.color, curve.width, curve.dashes);
}

void draw_mark(ViewContext& context, const PlotMark& mark, const PlotArea& area, float row) {
  if (!(mark.x >= area.x_low && mark.x <= area.x_high)) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float x = std::round(area.x_of(mark.x));
  list.AddLine({x, area.min.y}, {x, area.max.y}, mark.color, 1.5f);
  const SmallText text("{}", mark.name);
  const float width = context.fonts.text->CalcTextSizeA(Fonts::kSmallSize, FLT_MAX, 0.0f, text.c_str()).x;
  const float left = x + 4.0f + width <= area.max.x ? x + 4.0f : x - 4.0f - width;
  const ImVec2 at{std::round(left), area.min.y + 2.0f + row * (Fonts::kSmallSize + 3.0f)};
  list.AddRectFilled({at.x - 2.0f, at.y}, {at.x + width + 2.0f, at.y + Fonts::kSmallSize + 2.0f}, with_alpha(context.theme.panel, 0.8f));
  list.AddText(context.fonts.text, Fonts::kSmallSize, at, mark.color, text.c_str());
}

}  // namespace

void draw_small_plot(ViewContext& context, const char* id, ImVec2 min, ImVec2 max, const SmallPlot& plot) {
  const PlotArea area = place(plot, min, max);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  context.items.add(id, plot.title, min, max);
  list.AddText(context.fonts.semibold, Fonts::kSmallSize + 1.0f, {area.min.x, min.y + 3.0f}, context.theme.text, plot.title.data(),
               plot.title.data() + plot.title.size());
  const float unit = context.fonts.mono->CalcTextSizeA(Fonts::kSmallSize, FLT_MAX, 0.0f, plot.y_unit.data(),
                                                       plot.y_unit.data() + plot.y_unit.size()).x;
  list.AddText(context.fonts.mono, Fonts::kSmallSize, {std::round(area.min.x - 4.0f - unit), min.y + 4.0f}, context.theme.dim_text,
               plot.y_unit.data(), plot.y_unit.data() + plot.y_unit.size());
  list.AddRectFilled(area.min, area.max, with_alpha(context.theme.app, 0.45f));
  for (const PlotStretch& stretch : plot.stretches) {
    list.AddRectFilled({std::max(area.x_of(stretch.from), area.min.x), area.min.y},
                       {std::min(std::max(area.x_of(stretch.to), area.x_of(stretch.from) + 1.0f), area.max.x), area.max.y}, stretch.color);
  }
  draw_axes(context, plot, area);
  list.PushClipRect(area.min, area.max, true);
  for (const PlotCurve& curve : plot.curves) draw_curve(curve, area);
  float row = 0.0f;
  for (const PlotMark& mark : plot.marks) draw_mark(context, mark, area, row++);
  for (const PlotDot& dot : plot.dots) {
    if (!std::isfinite(dot.x) || !std::isfinite(dot.y)) continue;
    list.AddCircleFilled({area.x_of(dot.x), area.axis.y_of(dot.y)}, 4.5f, dot.color, 16);
    list.AddCircle({area.x_of(dot.x), area.axis.y_of(dot.y)}, 4.5f, context.theme.panel, 16, 1.5f);
  }
  list.PopClipRect();
}

ImVec4 plot_place(int index, int count, ImVec2 min, ImVec2 max, float least_width) {
  const int room = std::clamp(static_cast<int>((max.x - min.x) / least_width), 1, count);
  const int rows = (count + room - 1) / room;
  const int columns = (count + rows - 1) / rows;
  const float width = (max.x - min.x) / static_cast<float>(columns);
  const float height = (max.y - min.y) / static_cast<float>(rows);
  const float left = min.x + static_cast<float>(index % columns) * width;
  const float top = min.y + static_cast<float>(index / columns) * height;
  return {std::round(left), std::round(top), std::round(left + width), std::round(top + height)};
}

}  // namespace marey::app
