#include "wasm/views/viewport/gizmo.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "wasm/app/small_text.h"
#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSameAngle_rad = 0.5 * kPi / 180.0;

struct AxisEnd {
  Axis axis = Axis::X;
  bool negative = false;
  ImVec2 center;
  float nearness = 0.0f;  // 1 towards the viewer ... -1 away
};

glm::dvec3 direction_of(Axis axis, bool negative) {
  glm::dvec3 direction(0.0);
  direction[static_cast<int>(axis)] = negative ? -1.0 : 1.0;
  return direction;
}

std::array<AxisEnd, 6> place_ends(const ViewportState& state, ImVec2 center, float reach) {
  const ViewAxes& axes = state.view.axes();
  std::array<AxisEnd, 6> ends;
  for (int i = 0; i < 6; ++i) {
    AxisEnd& end = ends[idx(i)];
    end.axis = static_cast<Axis>(i / 2);
    end.negative = i % 2 == 1;
    const glm::dvec3 direction = direction_of(end.axis, end.negative);
    end.center = {center.x + static_cast<float>(glm::dot(direction, axes.right)) * reach,
                  center.y - static_cast<float>(glm::dot(direction, axes.up)) * reach};
    end.nearness = static_cast<float>(glm::dot(direction, axes.back));
  }
  std::sort(ends.begin(), ends.end(), [](const AxisEnd& a, const AxisEnd& b) { return a.nearness < b.nearness; });
  return ends;
}

void draw_end(const ViewContext& context, const AxisEnd& end, ImVec2 center, float radius, bool hovered) {
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const int axis = static_cast<int>(end.axis);
  const float alpha = 0.7f + 0.3f * end.nearness;
  const ImU32 color = with_alpha(context.theme.axis[axis], hovered ? 1.0f : alpha);
  if (end.negative) {
    draw_list.AddCircleFilled(end.center, radius * 0.72f, with_alpha(color, hovered ? 0.6f : 0.25f));
    draw_list.AddCircle(end.center, radius * 0.72f, color, 0, 1.2f);
    return;
  }
  draw_list.AddLine(center, end.center, color, 2.0f);
  draw_list.AddCircleFilled(end.center, radius, color);
  if (hovered) draw_list.AddCircle(end.center, radius + 1.5f, context.theme.text, 0, 1.5f);
  const char letter[] = {static_cast<char>('X' + axis), '\0'};
  ImGui::PushFont(context.fonts.semibold, Fonts::kSmallSize);
  const ImVec2 size = ImGui::CalcTextSize(letter);
  const ImU32 ink = context.theme.kind == ThemeKind::Dark ? context.theme.viewport_bottom : IM_COL32_WHITE;
  draw_list.AddText({end.center.x - 0.5f * size.x, end.center.y - 0.5f * size.y}, ink, letter);
  ImGui::PopFont();
}

// A second click on the same end turns to the opposite one.
void look_from(ViewportState& state, const AxisView& view, Axis up, const AxisEnd& end) {
  const AxisView* present = find_axis_view(state.camera.goal());
  const AxisView& wanted = present == &view ? axis_view_from(end.axis, !end.negative, up) : view;
  state.request.yaw_rad = wanted.yaw_rad;
  state.request.pitch_rad = wanted.pitch_rad;
}

}  // namespace

const std::array<AxisView, 6> kAxisViews = {{
    {"Front", "view.front", 0.0, 0.0},
    {"Back", "view.back", kPi, 0.0},
    {"Side", "view.side", 0.5 * kPi, 0.0},
    {"Opposite side", "view.side_opposite", -0.5 * kPi, 0.0},
    {"Top", "view.top", 0.0, 0.5 * kPi},
    {"Bottom", "view.bottom", 0.0, -0.5 * kPi},
}};

const AxisView* find_axis_view(const CameraPose& pose) {
  for (const AxisView& view : kAxisViews) {
    const double yaw = std::abs(std::remainder(pose.yaw_rad - view.yaw_rad, 2.0 * kPi));
    if (yaw < kSameAngle_rad && std::abs(pose.pitch_rad - view.pitch_rad) < kSameAngle_rad) return &view;
  }
  return nullptr;
}

const AxisView& axis_view_from(Axis axis, bool negative, Axis up) {
  const ViewAxes front = front_axes(up);
  const glm::dvec3 direction = direction_of(axis, negative);
  const double towards[] = {glm::dot(direction, front.back), glm::dot(direction, front.right),
                            glm::dot(direction, front.up)};
  for (int i = 0; i < 3; ++i) {
    if (towards[i] > 0.5) return kAxisViews[idx(2 * i)];
    if (towards[i] < -0.5) return kAxisViews[idx(2 * i + 1)];
  }
  return kAxisViews[0];
}

float gizmo_size(const ViewContext& context) { return context.options.touch ? 104.0f : 84.0f; }

void draw_gizmo(ViewContext& context, ViewportState& state, ImVec2 top_right) {
  const float size = gizmo_size(context);
  const float radius = size * 0.105f;
  const ImVec2 center{top_right.x - 0.5f * size, top_right.y + 0.5f * size};
  const Axis up = state.camera.up();
  for (const AxisEnd& end : place_ends(state, center, 0.5f * size - radius - 2.0f)) {
    const AxisView& view = axis_view_from(end.axis, end.negative, up);
    const SmallText id("viewport.gizmo.{}{}", end.negative ? "-" : "", static_cast<char>('x' + static_cast<int>(end.axis)));
    const float target = std::max(radius, context.options.touch ? 16.0f : 10.0f);
    ImGui::SetCursorScreenPos({end.center.x - target, end.center.y - target});
    ImGui::SetNextItemAllowOverlap();
    if (ImGui::InvisibleButton(id.c_str(), {2.0f * target, 2.0f * target})) look_from(state, view, up, end);
    context.items.add_last(id, view.name);
    const bool hovered = ImGui::IsItemHovered();
    draw_end(context, end, center, radius, hovered);
    if (hovered) context.status = "Click to look along this axis, twice from the other side.";
    ui::tool_tip(context, view.name, "Looks along this axis; again: from the other side.");
  }
}

}  // namespace marey::app
