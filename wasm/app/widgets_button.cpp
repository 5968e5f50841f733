#include <imgui_internal.h>

#include <algorithm>

#include "wasm/app/icons.h"
#include "wasm/app/shortcut.h"
#include "wasm/app/widgets.h"

namespace marey::app::ui {
namespace {

constexpr float kIconSize = Fonts::kTextSize;
constexpr float kIconGap = 6.0f;
constexpr float kLabelPadding = 10.0f;

struct ButtonFace {
  const char* icon = nullptr;
  std::string_view label;
  ButtonLook look = ButtonLook::Plain;
  bool enabled = true;
  bool active = false;
};

struct ButtonState {
  bool hovered = false;
  bool held = false;
};

void draw_ground(const Theme& theme, const ButtonFace& face, ButtonState state, ImVec2 min, ImVec2 max) {
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  const ImU32 touched = state.held ? theme.pressed : theme.hovered;
  if (face.look == ButtonLook::Primary) {
    draw_list.AddRectFilled(min, max, with_alpha(theme.accent, face.enabled ? 1.0f : 0.35f), rounding);
    const float shade = !face.enabled ? 0.0f : state.held ? 0.22f : state.hovered ? 0.12f : 0.0f;
    draw_list.AddRectFilled(min, max, with_alpha(theme.on_accent, shade), rounding);
    return;
  }
  if (face.active) draw_list.AddRectFilled(min, max, with_alpha(theme.accent, 0.18f), rounding);
  if (face.enabled && state.hovered) {
    draw_list.AddRectFilled(min, max, face.active ? with_alpha(theme.accent, 0.1f) : touched, rounding);
  } else if (face.look == ButtonLook::Raised) {
    draw_list.AddRectFilled(min, max, theme.raised, rounding);
  }
  if (face.look == ButtonLook::Raised) draw_list.AddRect(min, max, theme.line, rounding, 0, device_pixel());
}

ImU32 face_color(const Theme& theme, const ButtonFace& face) {
  const ImU32 color = face.look == ButtonLook::Primary ? theme.on_accent : face.active ? theme.accent : theme.text;
  return face.enabled ? color : with_alpha(color, face.look == ButtonLook::Primary ? 0.7f : 0.4f);
}

ImFont* label_font(const ViewContext& context, const ButtonFace& face) {
  return face.look == ButtonLook::Primary ? context.fonts.semibold : context.fonts.text;
}

ImVec2 label_size(const ViewContext& context, const ButtonFace& face) {
  return label_font(context, face)->CalcTextSizeA(Fonts::kTextSize, 1e6f, 0.0f, face.label.data(),
                                                  face.label.data() + face.label.size());
}

ImVec2 button_size(const ViewContext& context, const ButtonFace& face) {
  const float height = ImGui::GetFrameHeight();
  if (face.label.empty()) return {height, height};
  const float icon_width = face.icon != nullptr ? kIconSize + kIconGap : 0.0f;
  return {std::ceil(label_size(context, face).x + icon_width + 2.0f * kLabelPadding), height};
}

void draw_face(const ViewContext& context, const ButtonFace& face, ImVec2 min, ImVec2 max) {
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const ImU32 color = face_color(context.theme, face);
  const float y = std::round((min.y + max.y - Fonts::kTextSize) * 0.5f);
  const float label_width = face.label.empty() ? 0.0f : label_size(context, face).x;
  const float icon_width = face.icon == nullptr ? 0.0f : face.label.empty() ? kIconSize : kIconSize + kIconGap;
  float x = std::round((min.x + max.x - label_width - icon_width) * 0.5f);
  if (face.icon != nullptr) draw_list.AddText(context.fonts.text, Fonts::kTextSize, ImVec2(x, y), color, face.icon);
  x += icon_width;
  draw_list.AddText(label_font(context, face), Fonts::kTextSize, ImVec2(x, y), color, face.label.data(),
                    face.label.data() + face.label.size());
}

bool draw_button(const ViewContext& context, const char* id, const ButtonFace& face) {
  const ImVec2 size = button_size(context, face);
  const bool pressed = ImGui::InvisibleButton(id, size, ImGuiButtonFlags_EnableNav);
  const ImVec2 min = ImGui::GetItemRectMin();
  const ImVec2 max = ImGui::GetItemRectMax();
  draw_ground(context.theme, face, {ImGui::IsItemHovered(), ImGui::IsItemActive()}, min, max);
  draw_face(context, face, min, max);
  return pressed && face.enabled;
}

// The name of an icon button's tool tip ends at the first full stop or colon; what follows is the help.
std::pair<std::string_view, std::string_view> split_tip(std::string_view tip) {
  const std::size_t end = tip.find_first_of(".:");
  if (end == std::string_view::npos || end + 1 >= tip.size()) return {tip.substr(0, end), {}};
  return {tip.substr(0, end), tip.substr(end + 2)};
}

}  // namespace

bool command_button(ViewContext& context, std::string_view command_id, ButtonLook look, bool with_label,
                    std::string_view id_suffix) {
  const Command* command = context.commands.find(command_id);
  if (command == nullptr) return false;
  const bool enabled = CommandRegistry::is_enabled(*command);
  const SmallText id("{}{}", command->id, id_suffix);
  const bool shows_label = with_label || command->icon == nullptr;
  const ButtonFace face{CommandRegistry::icon_of(*command), shows_label ? std::string_view(command->label) : std::string_view(), look,
                        enabled, command->checked && command->checked()};
  const bool ran = draw_button(context, id.c_str(), face);
  context.items.add_last(id, CommandRegistry::label_of(*command));
  command_tool_tip(context, *command);
  if (ran) context.commands.run(command_id);
  return ran;
}

bool icon_button(ViewContext& context, const char* id, const char* icon, std::string_view tip, bool active) {
  const bool pressed = draw_button(context, id, {icon, {}, ButtonLook::Plain, true, active});
  const auto [name, help] = split_tip(tip);
  context.items.add_last(id, name);
  tool_tip(context, name, help);
  return pressed;
}

bool text_button(ViewContext& context, const char* id, std::string_view label, std::string_view tip,
                 ButtonLook look) {
  const bool pressed = draw_button(context, id, {nullptr, label, look, true, false});
  context.items.add_last(id, label);
  tool_tip(context, label, tip);
  return pressed;
}

bool toggle(ViewContext& context, const char* id, std::string_view label, std::string_view tip, bool& on) {
  const float box = Fonts::kTextSize;
  const ImVec2 label_extent = ImGui::CalcTextSize(label.data(), label.data() + label.size());
  const float height = ImGui::GetFrameHeight();
  const bool pressed = ImGui::InvisibleButton(id, ImVec2(box + kIconGap + label_extent.x + 4.0f, height),
                                              ImGuiButtonFlags_EnableNav);
  if (pressed) on = !on;
  const ImVec2 min = ImGui::GetItemRectMin();
  const Theme& theme = context.theme;
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const ImVec2 box_min(min.x, std::round(min.y + (height - box) * 0.5f));
  const ImVec2 box_max(box_min.x + box, box_min.y + box);
  const ImU32 ground = on ? theme.accent : ImGui::IsItemHovered() ? theme.hovered : theme.raised;
  draw_list.AddRectFilled(box_min, box_max, ground, 4.0f);
  if (!on) draw_list.AddRect(box_min, box_max, theme.dim_text, 4.0f, 0, device_pixel());
  if (on) {
    draw_list.AddText(context.fonts.text, Fonts::kSmallSize, ImVec2(box_min.x + 1.5f, box_min.y + 1.5f), theme.on_accent,
                      icons::kCheck);
  }
  draw_list.AddText(ImVec2(box_max.x + kIconGap, std::round(min.y + (height - Fonts::kTextSize) * 0.5f)), theme.text,
                    label.data(), label.data() + label.size());
  context.items.add_last(id, label);
  tool_tip(context, label, tip);
  return pressed;
}

}  // namespace marey::app::ui
