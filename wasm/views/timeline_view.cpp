#include "wasm/views/timeline_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "wasm/app/widgets.h"
#include "wasm/views/graph/graph_axes.h"
#include "wasm/views/time_gutter.h"

namespace marey::app {
namespace {

constexpr float kHandleWidth = 8.0f;
constexpr float kHandleReach = 7.0f;
constexpr float kBandHeight = 6.0f;
constexpr double kWheelZoom = 1.15;

int frame_count(const ViewContext& context) { return context.session.document.motion().frame_count(); }

ImDrawList& draw_list() { return *ImGui::GetWindowDrawList(); }

}  // namespace

void TimelineView::place(ViewContext& context) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  top_ = corner.y;
  bottom_ = corner.y + kHeight;
  TimeWindow& time = context.time_window;
  time.left = corner.x + time_gutter_left(context.options.compact);
  time.right = std::max(time.left + 40.0f, corner.x + width - time_gutter_right(context.options.compact));
}

TimelineView::Handle TimelineView::handle_at(const ViewContext& context, float x, float y) const {
  const FrameRange range = context.session.playback.range();
  if (y >= bottom_ - kBandHeight - 4.0f) {
    if (std::abs(x - context.time_window.x_of(range.first)) <= kHandleReach) return Handle::RangeIn;
    if (std::abs(x - context.time_window.x_of(range.end() - 1)) <= kHandleReach) return Handle::RangeOut;
  }
  return Handle::Cursor;
}

void TimelineView::drag_handle(ViewContext& context) {
  Playback& playback = context.session.playback;
  const FrameRange range = playback.range();
  const int last = frame_count(context) - 1;
  const double at = std::round(context.time_window.frame_at(ImGui::GetIO().MousePos.x));
  const int frame = static_cast<int>(std::clamp(at, 0.0, static_cast<double>(std::max(0, last))));
  if (dragged_ == Handle::Cursor) playback.set_position(frame);
  if (dragged_ == Handle::RangeIn) {
    const int first = std::min(frame, range.end() - 1);
    playback.set_range({first, range.end() - first});
  }
  if (dragged_ == Handle::RangeOut) playback.set_range({range.first, std::max(1, frame + 1 - range.first)});
}

void TimelineView::handle_input(ViewContext& context) {
  const ImGuiIO& io = ImGui::GetIO();
  TimeWindow& time = context.time_window;
  const bool hovered = ImGui::IsItemHovered();
  if (ImGui::IsItemActivated() && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    dragged_ = handle_at(context, io.MousePos.x, io.MousePos.y);
    if (dragged_ == Handle::Cursor) context.session.playback.set_playing(false);
  }
  // The last move may come in the frame of the release.
  if (dragged_ != Handle::None && (ImGui::IsItemActive() || ImGui::IsItemDeactivated())) drag_handle(context);
  if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Middle)) {
    time.pan(-static_cast<double>(io.MouseDelta.x) * time.frames_per_unit(), frame_count(context));
  }
  if (ImGui::IsItemDeactivated()) dragged_ = Handle::None;
  if (!hovered) return;
  const double turns = static_cast<double>(io.MouseWheel);
  if (turns != 0.0 && !io.KeyShift) time.zoom(io.MousePos.x, std::pow(kWheelZoom, -turns), frame_count(context));
  const double sideways = static_cast<double>(io.MouseWheelH) + (io.KeyShift ? turns : 0.0);
  if (sideways != 0.0) time.pan(-0.1 * sideways * (time.last - time.first), frame_count(context));
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) time.fit(frame_count(context));
  const bool over_handle = handle_at(context, io.MousePos.x, io.MousePos.y) != Handle::Cursor;
  ImGui::SetMouseCursor(over_handle ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_Hand);
  context.status = over_handle ? "Drag to set the range that plays." : "Drag to scrub. Wheel zooms, double click fits.";
}

void TimelineView::draw_ruler(ViewContext& context) const {
  const TimeWindow& time = context.time_window;
  const Ticks ticks = frame_ticks(time);
  const float size = Fonts::kSmallSize;
  for (int i = 0; i < ticks.count; ++i) {
    const double number = ticks.at(i);
    if (number < 1.0 || number > frame_count(context)) continue;
    const float x = std::round(time.x_of(number - 1.0));
    draw_list().AddLine({x, bottom_ - kBandHeight - 4.0f}, {x, bottom_ - kBandHeight}, context.theme.dim_text);
    const std::string label = fmt::format("{:.0f}", number);
    const float width = context.fonts.mono->CalcTextSizeA(size, FLT_MAX, 0.0f, label.c_str()).x;
    draw_list().AddText(context.fonts.mono, size, {std::round(x - 0.5f * width), top_ + 4.0f}, context.theme.dim_text,
                        label.c_str());
  }
  if (context.options.compact) return;
  draw_list().AddText(context.fonts.text, size, {time.left - kAxisGutter - kChannelListWidth + 10.0f, top_ + 6.0f},
                      context.theme.dim_text, "Frame");
}

void TimelineView::draw_range(ViewContext& context) const {
  const TimeWindow& time = context.time_window;
  const FrameRange range = context.session.playback.range();
  const float left = time.x_of(range.first);
  const float right = time.x_of(range.end() - 1);
  const float y = bottom_ - kBandHeight;
  draw_list().AddRectFilled({time.left, y}, {time.right, bottom_}, with_alpha(context.theme.line, 0.5f));
  draw_list().AddRectFilled({left, y}, {right, bottom_}, with_alpha(context.theme.accent, 0.45f));
  for (const float x : {left, right}) {
    draw_list().AddRectFilled({x - 0.5f * kHandleWidth, y - 2.0f}, {x + 0.5f * kHandleWidth, bottom_ + 2.0f},
                              context.theme.accent, 2.0f);
  }
}

void TimelineView::draw_cursor(ViewContext& context) const {
  const Playback& playback = context.session.playback;
  const float x = std::round(context.time_window.x_of(playback.position()));
  if (x < context.time_window.left - 1.0f || x > context.time_window.right + 1.0f) return;
  const std::string label = fmt::format("{}", playback.frame() + 1);
  const float size = Fonts::kSmallSize;
  const float half = 0.5f * context.fonts.mono->CalcTextSizeA(size, FLT_MAX, 0.0f, label.c_str()).x + 5.0f;
  draw_list().AddRectFilled({x - half, top_ + 2.0f}, {x + half, top_ + 18.0f}, context.theme.cursor, 4.0f);
  draw_list().AddLine({x, top_ + 18.0f}, {x, bottom_}, context.theme.cursor, 1.5f);
  draw_list().AddText(context.fonts.mono, size, {std::round(x - half + 5.0f), top_ + 4.0f}, context.theme.app,
                      label.c_str());
}

void TimelineView::add_items(ViewContext& context) const {
  const TimeWindow& time = context.time_window;
  const FrameRange range = context.session.playback.range();
  const auto add = [&](const char* id, const char* label, double frame, float top, float bottom) {
    const float x = time.x_of(frame);
    context.items.add(id, label, {x - kHandleReach, top}, {x + kHandleReach, bottom});
  };
  add("timeline.range_in", "First frame that plays", range.first, bottom_ - kBandHeight - 2.0f, bottom_);
  add("timeline.range_out", "Last frame that plays", range.end() - 1, bottom_ - kBandHeight - 2.0f, bottom_);
  add("timeline.cursor", "Frame cursor", context.session.playback.position(), top_, bottom_ - kBandHeight - 4.0f);
}

void TimelineView::draw(ViewContext& context) {
  place(context);
  const TimeWindow& time = context.time_window;
  if (frame_count(context) == 0) {
    ImGui::Dummy({ImGui::GetContentRegionAvail().x, kHeight});
    return;
  }
  ImGui::SetCursorScreenPos({time.left, top_});
  ImGui::InvisibleButton("timeline.ruler", {time.right - time.left, kHeight},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  context.items.add_last("timeline.ruler", "Frames");
  handle_input(context);
  draw_list().PushClipRect({time.left - kHandleWidth, top_}, {time.right + kHandleWidth, bottom_ + 2.0f}, true);
  draw_range(context);
  draw_list().PopClipRect();
  draw_ruler(context);
  draw_cursor(context);
  add_items(context);
}

}  // namespace marey::app
