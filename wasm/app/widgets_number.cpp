#include <imgui_internal.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "wasm/app/number_text.h"
#include "wasm/app/widgets.h"

namespace marey::app::ui {
namespace {

constexpr std::string_view kNumberHelp =
    "Drag to change, double click to type. With the focus: arrow keys step, Enter types, Escape reverts.";

struct Field {
  ImGuiID item = 0;
  std::string_view label;
  double value = 0.0;
  const NumberFormat& format;
};

double held_in(const NumberFormat& format, double value) { return std::clamp(value, format.low, format.high); }

double rounded_to(const NumberFormat& format, double value) {
  const double scale = std::pow(10.0, format.decimals);
  return std::round(value * scale) / scale;
}

double step_factor() {
  const ImGuiIO& io = ImGui::GetIO();
  return io.KeyShift ? 10.0 : io.KeyAlt ? 0.1 : 1.0;
}

void begin_typing(WidgetState& state, const Field& field) {
  state.number_id = field.item;
  state.number_typing = true;
  state.number_typing_frames = 0;
  state.number_text = editable_number(field.value);
}

NumberResult finish_typing(ViewContext& context, const Field& field) {
  WidgetState& state = context.widgets;
  state.number_id = 0;
  state.number_typing = false;
  if (state.number_text == editable_number(field.value)) return {};
  const auto typed = read_typed_number(state.number_text, field.format.unit);
  if (!typed) {
    context.status = "\"" + state.number_text + "\" is not a number, so nothing changed.";
    return {};
  }
  return {NumberEvent::Committed, held_in(field.format, *typed), state.new_gesture()};
}

NumberResult draw_typing(ViewContext& context, const char* id, const Field& field) {
  WidgetState& state = context.widgets;
  if (state.number_typing_frames == 0) ImGui::SetKeyboardFocusHere();
  ImGui::PushFont(context.fonts.mono, 0.0f);
  ImGui::SetNextItemWidth(field.format.width);
  const bool entered = ImGui::InputText(SmallText("##typed.{}", id).c_str(), &state.number_text,
                                        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopFont();
  const bool active = ImGui::IsItemActive();
  const bool left = ImGui::IsItemDeactivated();
  ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), context.theme.accent, 4.0f, 0, 1.5f);
  context.items.add_last(id, std::string(field.label));
  ++state.number_typing_frames;
  const bool never_began = !active && state.number_typing_frames > 3;
  return entered || left || never_began ? finish_typing(context, field) : NumberResult{};
}

void draw_resting(const ViewContext& context, const Field& field, bool focused) {
  const Theme& theme = context.theme;
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const ImVec2 min = ImGui::GetItemRectMin();
  const ImVec2 max = ImGui::GetItemRectMax();
  const bool touched = ImGui::IsItemHovered() || ImGui::IsItemActive();
  draw_list.AddRectFilled(min, max, touched ? theme.hovered : theme.raised, 4.0f);
  draw_list.AddRect(min, max, focused ? theme.accent : theme.line, 4.0f, 0, focused ? 1.5f : device_pixel());
  const std::string_view unit = field.format.unit;
  const float unit_width = unit.empty() ? 0.0f : ImGui::CalcTextSize(unit.data(), unit.data() + unit.size()).x;
  const float gap = unit.empty() || unit == "°" ? 0.0f : 4.0f;
  const std::string number = displayed_number(field.value, field.format.decimals);
  const float number_width = context.fonts.mono->CalcTextSizeA(Fonts::kTextSize, 1e6f, 0.0f, number.c_str()).x;
  const float y = std::round((min.y + max.y - Fonts::kTextSize) * 0.5f);
  const float unit_x = max.x - 8.0f - unit_width;
  draw_list.PushClipRect(min, max, true);
  draw_list.AddText(context.fonts.mono, Fonts::kTextSize, ImVec2(std::round(unit_x - gap - number_width), y), theme.text,
                    number.c_str());
  draw_list.AddText(ImVec2(unit_x, y), theme.dim_text, unit.data(), unit.data() + unit.size());
  draw_list.PopClipRect();
}

// The value for how far was dragged, this frame's move included.
double follow_move(WidgetState& state, const Field& field) {
  state.number_dragged += static_cast<double>(ImGui::GetIO().MouseDelta.x) * step_factor();
  return held_in(field.format, rounded_to(field.format, state.number_start + state.number_dragged * field.format.step));
}

NumberResult follow_drag(ViewContext& context, const Field& field) {
  WidgetState& state = context.widgets;
  if (ImGui::IsItemActivated()) {
    state.number_id = field.item;
    state.number_start = field.value;
    state.number_dragged = 0.0;
    state.number_gesture = 0;
  }
  if (state.number_id != field.item) return {};
  // ImGui's navigation takes the activity away on Escape before the field sees the key.
  if (state.number_gesture != 0 && ImGui::IsKeyPressed(ImGuiKey_Escape)) {
    if (ImGui::IsItemActive()) ImGui::ClearActiveID();
    state.number_id = 0;
    return {NumberEvent::Cancelled, state.number_start, state.number_gesture};
  }
  if (!ImGui::IsItemActive()) return {};
  if (state.number_gesture == 0) {
    if (!ImGui::IsMouseDragging(ImGuiMouseButton_Left, 3.0f)) return {};
    state.number_gesture = state.new_gesture();
    // What was moved below the threshold counts too.
    const float before = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0.0f).x - ImGui::GetIO().MouseDelta.x;
    state.number_dragged = static_cast<double>(before) * step_factor();
  }
  return {NumberEvent::Live, follow_move(state, field), state.number_gesture};
}

// 1 and -1 for arrow keys, which the focused field takes from ImGui's navigation and from the shortcuts.
int pressed_steps(ImGuiID item) {
  constexpr std::array kKeys = {std::pair{ImGuiKey_UpArrow, 1}, std::pair{ImGuiKey_DownArrow, -1},
                                std::pair{ImGuiKey_RightArrow, 1}, std::pair{ImGuiKey_LeftArrow, -1}};
  int steps = 0;
  for (const auto& [key, step] : kKeys) {
    ImGui::SetKeyOwner(key, item);
    if (ImGui::IsKeyPressed(key, ImGuiInputFlags_Repeat, item)) steps += step;
  }
  return steps;
}

bool is_focused(ImGuiID item) {
  const ImGuiContext& imgui = *ImGui::GetCurrentContext();
  return imgui.NavId == item && imgui.ActiveId == 0 && (imgui.NavCursorVisible || imgui.LastActiveId == item);
}

NumberResult follow_arrow_keys(ViewContext& context, const Field& field) {
  WidgetState& state = context.widgets;
  const int steps = pressed_steps(field.item);
  if (steps == 0) return {};
  if (state.number_step_id != field.item) {
    state.number_step_id = field.item;
    state.number_gesture = state.new_gesture();
  }
  const double stepped = rounded_to(field.format, field.value + steps * field.format.step * step_factor());
  return {NumberEvent::Committed, held_in(field.format, stepped), state.number_gesture};
}

}  // namespace

NumberResult number_field(ViewContext& context, const char* id, std::string_view label, double value,
                          const NumberFormat& format) {
  WidgetState& state = context.widgets;
  const Field field{ImGui::GetID(id), label, value, format};
  if (state.number_typing && state.number_id == field.item) return draw_typing(context, id, field);

  const bool was_dragged = state.number_id == field.item && state.number_gesture != 0;
  const bool pressed = ImGui::InvisibleButton(id, ImVec2(format.width, ImGui::GetFrameHeight()),
                                              ImGuiButtonFlags_EnableNav);
  const bool focused = is_focused(field.item);
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  draw_resting(context, field, focused || ImGui::IsItemActive());
  context.items.add_last(id, label);
  tool_tip(context, label, kNumberHelp);

  NumberResult result = follow_drag(context, field);
  if (result.event != NumberEvent::None) return result;
  if (was_dragged && ImGui::IsItemDeactivated()) {
    state.number_id = 0;
    return {NumberEvent::Committed, follow_move(state, field), state.number_gesture};
  }
  const bool by_keyboard = pressed && ImGui::GetCurrentContext()->NavActivateId == field.item;
  const bool twice = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  if (by_keyboard || twice) begin_typing(state, field);
  if (focused) return follow_arrow_keys(context, field);
  if (state.number_step_id == field.item) state.number_step_id = 0;
  return {};
}

}  // namespace marey::app::ui
