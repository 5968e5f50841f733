#include "wasm/views/viewport/overlay.h"

#include <algorithm>
#include <cmath>

#include "wasm/app/widgets.h"
#include "wasm/views/viewport/gizmo.h"
#include "wasm/views/viewport/stage.h"

namespace marey::app {
namespace {

constexpr float kInset = 12.0f;
constexpr float kWidestScaleBar = 120.0f;
constexpr float kLineHeight = 16.0f;
constexpr std::string_view kButtons[] = {"view.frame_all", "view.follow_root", "view.orthographic",
                                         "view.strobe",    "view.trails",      "view.names"};

// In metres as far down as a decimetre, else in centimetres or millimetres.
SmallText metric(double metres) {
  if (metres >= 0.1) return SmallText("{:.3g} m", metres);
  if (metres >= 0.001) return SmallText("{:.3g} cm", metres * 100.0);
  return SmallText("{:.3g} mm", metres * 1000.0);
}

ImVec2 bottom_right(const ViewportState& state) {
  return {state.corner.x + static_cast<float>(state.view.size().x),
          state.corner.y + static_cast<float>(state.view.size().y)};
}

// Text over the scene, on a veil that keeps the lines of the grid from cutting it.
void draw_text(const ViewContext& context, ImVec2 place, ImU32 color, std::string_view text) {
  if (text.empty()) return;
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const ImVec2 size = ImGui::CalcTextSize(text.data(), text.data() + text.size());
  draw_list.AddRectFilled({place.x - 4.0f, place.y - 1.0f}, {place.x + size.x + 4.0f, place.y + size.y + 1.0f},
                          with_alpha(context.theme.viewport_bottom, 0.6f), 3.0f);
  draw_list.AddText(place, color, text.data(), text.data() + text.size());
}

// Returns the right end of what was drawn.
float draw_scale_bar(const ViewContext& context, const ViewportState& state) {
  const double depth = state.view.depth(state.camera.pose().target);
  const double metres_per_unit = context.session.document.settings().metres_per_unit;
  const ScaleBar bar = make_scale_bar(state.view.units_per_pixel(depth), kWidestScaleBar, metres_per_unit);
  const float left = std::round(state.corner.x + kInset);
  const float bottom = std::round(bottom_right(state).y - kInset);
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const ImU32 color = context.theme.dim_text;
  draw_list.AddLine({left, bottom - 2.0f}, {left + bar.width, bottom - 2.0f}, color, 1.5f);
  for (const float x : {left, left + bar.width}) draw_list.AddLine({x, bottom - 6.0f}, {x, bottom - 1.2f}, color, 1.5f);
  draw_text(context, {left, bottom - 8.0f - kLineHeight}, color, bar.label);
  return left + std::max(bar.width, ImGui::CalcTextSize(bar.label.c_str()).x);
}

void draw_status(const ViewContext& context, const ViewportState& state, float left) {
  if (context.status.empty()) return;
  const ImVec2 corner = bottom_right(state);
  const float room = corner.x - kInset - left - 16.0f;
  std::string_view text = context.status;
  const auto width = [&] { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; };
  // Sentences that find no room are dropped from the end.
  while (!text.empty() && width() > room) {
    const std::size_t stop = text.substr(0, text.size() - 1).find_last_of('.');
    text = stop == std::string_view::npos ? std::string_view() : text.substr(0, stop + 1);
  }
  draw_text(context, {std::round(corner.x - kInset - width()), corner.y - kInset - kLineHeight}, context.theme.dim_text, text);
}

void draw_buttons(ViewContext& context, const ViewportState& state, float top) {
  const float side = ImGui::GetFrameHeight();
  const float padding = 2.0f;
  const int fits = static_cast<int>((bottom_right(state).y - kInset - 2.0f * kLineHeight - top - 2.0f * padding) / side);
  const int count = std::clamp(fits, 0, static_cast<int>(std::size(kButtons)));
  if (count == 0) return;
  const ImVec2 min{std::round(bottom_right(state).x - kInset - side - 2.0f * padding), std::round(top)};
  const ImVec2 max{min.x + side + 2.0f * padding, min.y + static_cast<float>(count) * side + 2.0f * padding};
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  draw_list.AddRectFilled(min, max, with_alpha(context.theme.panel, 0.82f), 6.0f);
  draw_list.AddRect(min, max, context.theme.line, 6.0f, 0, ui::device_pixel());
  for (int i = 0; i < count; ++i) {
    ImGui::SetCursorScreenPos({min.x + padding, min.y + padding + static_cast<float>(i) * side});
    ui::command_button(context, kButtons[i], ui::ButtonLook::Plain, false, ".viewport");
  }
}

void draw_strobe_setting(ViewContext& context, ImVec2 place) {
  int& every = context.options.strobe_every_frames;
  const ui::NumberFormat format{.unit = "frames", .decimals = 0, .step = 0.2, .low = 1.0, .high = 1000.0, .width = 92.0f};
  constexpr std::string_view kLabel = "Strobe every";
  const float height = ImGui::GetFrameHeight();
  const ImVec2 size = ImGui::CalcTextSize(kLabel.data(), kLabel.data() + kLabel.size());
  draw_text(context, {place.x, std::round(place.y + 0.5f * (height - size.y))}, context.theme.dim_text, kLabel);
  ImGui::SetCursorScreenPos({place.x + std::round(size.x) + 8.0f, place.y});
  const auto result = ui::number_field(context, "viewport.strobe_every", "Strobe every", every, format);
  if (result.event != ui::NumberEvent::None) every = std::max(static_cast<int>(std::lround(result.value)), 1);
}

}  // namespace

ScaleBar make_scale_bar(double units_per_pixel, float widest, double metres_per_unit) {
  ScaleBar bar;
  bar.length = rounded_down_125(units_per_pixel * static_cast<double>(widest));
  bar.width = static_cast<float>(bar.length / units_per_pixel);
  const char* noun = bar.length == 1.0 ? "unit" : "units";
  bar.label = SmallText("{:.10g} {} = {}", bar.length, noun, metric(bar.length * metres_per_unit).view());
  return bar;
}

SmallText view_name(const CameraPose& pose) {
  const bool perspective = pose.perspective > 0.0;
  const AxisView* view = find_axis_view(pose);
  if (view == nullptr) return SmallText("{}", perspective ? "Perspective" : "Orthographic");
  return SmallText("{}, {}", view->name, perspective ? "perspective" : "orthographic");
}

void draw_overlay(ViewContext& context, ViewportState& state) {
  const float right = bottom_right(state).x;
  draw_gizmo(context, state, {right - kInset + 4.0f, state.corner.y + kInset - 4.0f});
  draw_buttons(context, state, state.corner.y + kInset + gizmo_size(context) + 4.0f);
  ImGui::PushFont(context.fonts.text, Fonts::kSmallSize);
  draw_text(context, {state.corner.x + kInset, state.corner.y + kInset}, context.theme.dim_text, view_name(state.camera.goal()));
  const float left = draw_scale_bar(context, state);
  draw_status(context, state, left);
  ImGui::PopFont();
  if (context.options.show_strobe) {
    draw_strobe_setting(context, {state.corner.x + kInset, state.corner.y + kInset + kLineHeight + 6.0f});
  }
}

}  // namespace marey::app
