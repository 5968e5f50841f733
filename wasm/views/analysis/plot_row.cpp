#include "wasm/views/analysis/plot_row.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "wasm/views/graph/ticks.h"

namespace marey::app {
namespace {

constexpr float kInset = 6.0f;
constexpr float kLineWidth = 1.75f;
constexpr float kProjectorWidth = 2.75f;
constexpr float kThinWidth = 1.0f;
constexpr float kOtherAlpha = 0.8f;
constexpr float kOtherWidth = 1.25f;
constexpr float kBandAlpha = 0.22f;
constexpr double kDenseSamplesPerColumn = 2.0;
constexpr double kWheelZoom = 1.15;
constexpr float kLetterHeight = 13.0f;
constexpr float kValueRoom = 20.0f;
constexpr double kRounding = 5e-10;

double value_at(const PlotLine& line, FrameIndex frame) {
  return frame >= 0 && frame < size_of(line.values) ? line.values[idx(frame)] : std::nan("");
}

}  // namespace

Dashes dashes_of(std::size_t other) {
  static constexpr float kDashed[] = {6.0f, 3.0f};
  static constexpr float kDotted[] = {1.5f, 3.0f};
  static constexpr float kDashDotted[] = {8.0f, 3.0f, 1.5f, 3.0f};
  static constexpr float kLongDashed[] = {14.0f, 4.0f};
  const Dashes patterns[kMostOtherClips] = {kDashed, kDotted, kDashDotted, kLongDashed};
  return patterns[other % kMostOtherClips];
}

ImU32 component_color(const Theme& theme, char component) {
  return component >= 'x' && component <= 'z' ? theme.axis[component - 'x'] : theme.accent;
}

SmallText value_text(double value) {
  if (!std::isfinite(value)) return SmallText("–");
  const double size = std::abs(value) < kRounding ? 0.0 : std::abs(value);
  if (size >= 1e6 || (size > 0.0 && size < 1e-3)) return SmallText("{:.2e}", value);
  return SmallText("{}", tick_label(value, size >= 100.0 ? 1 : size >= 1.0 ? 2 : 3));
}

void zoom_by_wheel(ViewContext& context) {
  const ImGuiIO& io = ImGui::GetIO();
  TimeWindow& time = context.time_window;
  const int frames = context.session.document.motion().frame_count();
  const double turns = static_cast<double>(io.MouseWheel);
  const double sideways = static_cast<double>(io.MouseWheelH) + (io.KeyShift ? turns : 0.0);
  if (sideways != 0.0) time.pan(-0.1 * sideways * (time.last - time.first), frames);
  else if (turns != 0.0) time.zoom(io.MousePos.x, std::pow(kWheelZoom, -turns), frames);
}

void PlotRow::follow(const AnalysisPlot& plot, std::uint64_t serial) {
  if (serial == serial_) return;
  serial_ = serial;
  range_ = {};
  pyramids_.clear();
  const auto add = [&](const std::vector<PlotLine>& lines, bool widens) {
    for (const PlotLine& line : lines) {
      if (widens) range_.add(line.values);
      pyramids_.emplace_back();
      pyramids_.back().update(line.values, {0, size_of(line.values)});
    }
  };
  add(plot.lines, true);
  add(plot.raw, false);
  for (const OtherLines& other : plot.others) add(other.lines, true);
}

void PlotRow::draw_ground(ViewContext& context, const AnalysisPlot& plot) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(area_.min, area_.max, with_alpha(context.theme.app, 0.45f));
  draw_frame_grid(list, area_, context.time_window, context.theme);
  draw_value_grid(list, area_, axis_, context.theme, kValueRoom);
  for (const MotionEvent& event : context.analysis.events()) {
    const float x = std::round(context.time_window.x_of(event.frame)) + 0.5f;
    if (x > area_.min.x && x < area_.max.x) list.AddLine({x, area_.min.y}, {x, area_.max.y}, with_alpha(context.theme.dim_text, 0.5f));
  }
  if (plot.choice.quantity->level == DerivativeLevel::Pose || plot.lines.empty()) return;
  const Motion& motion = context.session.document.motion();
  const int reach = uncertain_end_frames(context.analysis.derivation, 1.0 / motion.frame_time_s());
  const ImU32 shade = with_alpha(context.theme.warning, 0.13f);
  const float first = context.time_window.x_of(std::min(reach, motion.frame_count()));
  const float last = context.time_window.x_of(std::max(motion.frame_count() - 1 - reach, 0));
  const float start = context.time_window.x_of(0.0);
  const float end = context.time_window.x_of(motion.frame_count() - 1);
  list.PushClipRect(area_.min, area_.max, true);
  list.AddRectFilled({start, area_.min.y}, {first, area_.max.y}, shade);
  list.AddRectFilled({last, area_.min.y}, {end, area_.max.y}, shade);
  list.PopClipRect();
}

void PlotRow::add_line(ViewContext& context, const PlotLine& line, std::size_t number, ImU32 color, float width) {
  if (!dense_) {
    shape_.build(line.values, context.time_window, axis_);
    shape_.draw(*ImGui::GetWindowDrawList(), color, width);
    return;
  }
  build_band(context, line, number);
  band_.add_to(batch_, color, width);
}

// Upright slices from sample to sample, no narrower than a unit; without smoothed edges, which would show between them.
void PlotRow::draw_bands(ViewContext& context, const AnalysisPlot& plot) const {
  const TimeWindow& time = context.time_window;
  const int step = std::max(1, static_cast<int>(time.frames_per_unit()));
  const int first = std::max(0, static_cast<int>(std::floor(time.first)));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImDrawListFlags flags = list.Flags;
  list.Flags &= ~ImDrawListFlags_AntiAliasedFill;
  for (const PlotBand& band : plot.bands) {
    const ImU32 color = with_alpha(component_color(context.theme, band.component), kBandAlpha);
    const int last = std::min(size_of(band.low) - 1, static_cast<int>(std::ceil(time.last)));
    for (int frame = first; frame + step <= last; frame += step) {
      const auto [a, b] = std::pair(idx(frame), idx(frame + step));
      if (!std::isfinite(band.low[a]) || !std::isfinite(band.low[b])) continue;
      const float left = time.x_of(frame);
      const float right = time.x_of(frame + step);
      list.AddQuadFilled({left, axis_.y_of(band.high[a])}, {right, axis_.y_of(band.high[b])}, {right, axis_.y_of(band.low[b])},
                         {left, axis_.y_of(band.low[a])}, color);
    }
  }
  list.Flags = flags;
}

// Dashes follow a line: where there are several samples to a pixel, that through the middle of each column.
void PlotRow::draw_others(ViewContext& context, const AnalysisPlot& plot) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::size_t number = plot.lines.size() + plot.raw.size();
  for (std::size_t other = 0; other < plot.others.size(); ++other) {
    for (const PlotLine& line : plot.others[other].lines) {
      const ImU32 color = with_alpha(component_color(context.theme, line.component), kOtherAlpha);
      if (dense_) {
        build_band(context, line, number);
        band_.draw_middle(list, color, kOtherWidth, dashes_of(other));
      } else {
        shape_.build(line.values, context.time_window, axis_);
        shape_.draw(list, color, kOtherWidth, dashes_of(other));
      }
      ++number;
    }
  }
}

void PlotRow::build_band(const ViewContext& context, const PlotLine& line, std::size_t number) {
  extents_.resize(idx(columns_.count));
  compute_column_extents(pyramids_[number], line.values, columns_, extents_);
  band_.build(extents_, columns_, context.time_window, axis_);
}

void PlotRow::draw_lines(ViewContext& context, const AnalysisPlot& plot) {
  const Theme& theme = context.theme;
  columns_ = visible_columns(context.time_window, context.session.document.motion().frame_count());
  dense_ = columns_.frames_per_column >= kDenseSamplesPerColumn;
  const float width = context.options.projector ? kProjectorWidth : kLineWidth;
  const Look look{serial_, context.time_window, axis_, {theme.axis[0], theme.axis[1], theme.axis[2], theme.accent, theme.ghost}, width};
  draw_others(context, plot);
  const bool is_same = dense_ && look == look_;
  look_ = look;
  if (!is_same) {
    if (dense_) batch_.begin();
    std::size_t number = plot.lines.size();
    for (const PlotLine& line : plot.raw) add_line(context, line, number++, theme.ghost, kThinWidth);
    number = 0;
    for (const PlotLine& line : plot.lines) add_line(context, line, number++, component_color(theme, line.component), width);
    if (dense_) batch_.finish();
  }
  if (dense_) add_curve_batch(*ImGui::GetWindowDrawList(), batch_);
}

// The letters of the components, beside the last values in sight; none covers another.
void PlotRow::draw_ends(ViewContext& context, const AnalysisPlot& plot) const {
  struct End {
    float y = 0.0f;
    char letter = 0;
  };
  std::array<End, 3> ends;
  std::size_t count = 0;
  const int last = std::min(static_cast<int>(std::floor(context.time_window.last)), context.session.document.motion().frame_count() - 1);
  for (const PlotLine& line : plot.lines) {
    int frame = last;
    while (frame > 0 && frame > last - 64 && !std::isfinite(value_at(line, frame))) --frame;
    const double value = value_at(line, frame);
    if (line.component == 0 || !std::isfinite(value) || count == ends.size()) continue;
    const End end{axis_.y_of(value) - 0.5f * kLetterHeight, line.component};
    std::size_t place = count++;
    for (; place > 0 && ends[place - 1].y > end.y; --place) ends[place] = ends[place - 1];
    ends[place] = end;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const float above = i == 0 ? area_.min.y : ends[i - 1].y + kLetterHeight;
    const float below = area_.max.y - kLetterHeight * static_cast<float>(count - i);
    ends[i].y = std::min(std::max(ends[i].y, above), std::max(below, area_.min.y));
    const char text[] = {static_cast<char>(ends[i].letter - 'x' + 'X'), '\0'};
    ImGui::GetWindowDrawList()->AddText(context.fonts.semibold, Fonts::kSmallSize, {area_.max.x + 6.0f, std::round(ends[i].y)},
                                        component_color(context.theme, ends[i].letter), text);
  }
}

void PlotRow::draw_cursor(ViewContext& context, const AnalysisPlot& plot) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float x = std::round(context.time_window.x_of(context.session.playback.position()));
  if (x < area_.min.x || x > area_.max.x) return;
  list.AddLine({x, area_.min.y}, {x, area_.max.y}, context.theme.cursor, 1.5f);
  for (const PlotLine& line : plot.lines) {
    const double value = value_at(line, context.session.playback.frame());
    if (!std::isfinite(value)) continue;
    list.AddCircleFilled({x, axis_.y_of(value)}, 3.5f, component_color(context.theme, line.component), 12);
    list.AddCircle({x, axis_.y_of(value)}, 3.5f, context.theme.panel, 12, 1.0f);
  }
}

void PlotRow::handle_input(ViewContext& context, const AnalysisPlot& plot, int index) const {
  ImGui::SetCursorScreenPos(area_.min);
  const SmallText id("plots.canvas.{}", index);
  ImGui::SetNextItemAllowOverlap();
  ImGui::InvisibleButton(id.c_str(), {area_.max.x - area_.min.x, area_.max.y - area_.min.y},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  context.items.add_last(id, plot.choice.quantity->label);
  const ImGuiIO& io = ImGui::GetIO();
  TimeWindow& time = context.time_window;
  const int frames = context.session.document.motion().frame_count();
  if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    context.session.playback.set_position(std::round(time.frame_at(io.MousePos.x)));
  } else if (ImGui::IsItemActive()) {
    time.pan(-static_cast<double>(io.MouseDelta.x) * time.frames_per_unit(), frames);
  }
  if (!ImGui::IsItemHovered()) return;
  context.status = "Drag to move the cursor. Wheel: zoom in time. Shift+wheel: pan.";
  zoom_by_wheel(context);
}

void PlotRow::draw(ViewContext& context, const AnalysisPlot& plot, std::uint64_t serial, int index, ImVec2 min, ImVec2 max) {
  follow(plot, serial);
  area_ = {{context.time_window.left, min.y + kInset}, {context.time_window.right, max.y - kInset}};
  if (area_.max.y - area_.min.y < 12.0f || area_.max.x - area_.min.x < 12.0f) return;
  axis_ = {};
  if (!range_.empty) axis_.fit(range_.low, range_.high, std::max(kLeastHeight, 1e-6 * std::max(std::abs(range_.low), std::abs(range_.high))));
  axis_.top = area_.min.y;
  axis_.bottom = area_.max.y;
  draw_ground(context, plot);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(area_.min, area_.max, true);
  draw_bands(context, plot);
  draw_lines(context, plot);
  draw_cursor(context, plot);
  list.PopClipRect();
  draw_ends(context, plot);
  draw_value_labels(list, area_, axis_, AxisSide::Left, plot.unit == "°" ? plot.unit : "", context.theme, context.fonts, kValueRoom);
  handle_input(context, plot, index);
}

}  // namespace marey::app
