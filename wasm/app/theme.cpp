#include "wasm/app/theme.h"

#include <algorithm>

namespace marey::app {
namespace {

constexpr ImU32 rgb(unsigned hex, unsigned alpha = 255) {
  return IM_COL32((hex >> 16) & 255U, (hex >> 8) & 255U, hex & 255U, alpha);
}

Theme make_dark_theme() {
  Theme theme;
  theme.kind = ThemeKind::Dark;
  theme.app = rgb(0x14161A);
  theme.panel = rgb(0x1B1E23);
  theme.raised = rgb(0x24282F);
  theme.hovered = rgb(0x2D323B);
  theme.pressed = rgb(0x363C47);
  theme.line = rgb(0x2F343C);
  theme.text = rgb(0xE7EAEE);
  theme.dim_text = rgb(0x9BA4B0);
  theme.accent = rgb(0x5B9DFF);
  theme.on_accent = rgb(0x0B1524);
  theme.selection = rgb(0xFFC24B);
  theme.cursor = rgb(0xFF5D73);
  theme.ok = rgb(0x3FB984);
  theme.warning = rgb(0xE5A53B);
  theme.error = rgb(0xF0616D);
  theme.axis[0] = rgb(0xFF6B57);
  theme.axis[1] = rgb(0x43C98A);
  theme.axis[2] = rgb(0x5AA9FF);
  theme.left = rgb(0xFF9D5C);
  theme.right = rgb(0x6FA8FF);
  theme.middle = rgb(0xC3C9D2);
  theme.viewport_top = rgb(0x262B33);
  theme.viewport_bottom = rgb(0x15181C);
  theme.grid = rgb(0x4A515C);
  theme.ghost = rgb(0x7C8592);
  return theme;
}

Theme make_light_theme() {
  Theme theme;
  theme.kind = ThemeKind::Light;
  theme.app = rgb(0xECEEF1);
  theme.panel = rgb(0xFAFBFC);
  theme.raised = rgb(0xFFFFFF);
  theme.hovered = rgb(0xE9ECF1);
  theme.pressed = rgb(0xDDE2E9);
  theme.line = rgb(0xD5DAE1);
  theme.text = rgb(0x1B1F24);
  theme.dim_text = rgb(0x5B6571);
  theme.accent = rgb(0x1F6FEB);
  theme.on_accent = rgb(0xFFFFFF);
  theme.selection = rgb(0xB97A00);
  theme.cursor = rgb(0xD1344B);
  theme.ok = rgb(0x17805A);
  theme.warning = rgb(0xA66A00);
  theme.error = rgb(0xC62F3D);
  theme.axis[0] = rgb(0xC93A22);
  theme.axis[1] = rgb(0x0F8A5A);
  theme.axis[2] = rgb(0x1C6FD0);
  theme.left = rgb(0xC8631B);
  theme.right = rgb(0x2B67C7);
  theme.middle = rgb(0x66707C);
  theme.viewport_top = rgb(0xF7F8FA);
  theme.viewport_bottom = rgb(0xDFE4EA);
  theme.grid = rgb(0xA9B2BE);
  theme.ghost = rgb(0x98A2AF);
  return theme;
}

void set_measures(ImGuiStyle& style, bool touch) {
  style.WindowPadding = ImVec2(12, 8);
  style.FramePadding = ImVec2(8, touch ? 12.0f : 6.0f);
  style.ItemSpacing = ImVec2(8, touch ? 8.0f : 4.0f);
  style.ItemInnerSpacing = ImVec2(8, 4);
  style.CellPadding = ImVec2(8, 4);
  style.IndentSpacing = 16;
  style.ScrollbarSize = 10;
  style.GrabMinSize = 24;
  style.WindowRounding = style.PopupRounding = 6;
  style.ChildRounding = 0;
  style.FrameRounding = style.GrabRounding = style.TabRounding = 4;
  style.ScrollbarRounding = 5;
  style.ChildBorderSize = style.FrameBorderSize = style.TabBorderSize = 0;
  style.SeparatorTextBorderSize = 1;
  style.DisabledAlpha = 0.45f;
  style.DisplaySafeAreaPadding = ImVec2(8, 8);
  style.HoverStationaryDelay = 0.12f;
  style.HoverDelayNormal = 0.45f;
  style.CircleTessellationMaxError = 0.15f;
  style.CurveTessellationTol = 0.6f;
}

void set_color(ImGuiStyle& style, ImGuiCol role, ImU32 color) {
  style.Colors[role] = ImGui::ColorConvertU32ToFloat4(color);
}

void set_surface_colors(ImGuiStyle& style, const Theme& theme) {
  set_color(style, ImGuiCol_Text, theme.text);
  set_color(style, ImGuiCol_TextDisabled, theme.dim_text);
  set_color(style, ImGuiCol_WindowBg, theme.panel);
  set_color(style, ImGuiCol_ChildBg, with_alpha(theme.panel, 0));
  set_color(style, ImGuiCol_PopupBg, theme.raised);
  set_color(style, ImGuiCol_Border, theme.line);
  set_color(style, ImGuiCol_BorderShadow, with_alpha(theme.line, 0));
  set_color(style, ImGuiCol_MenuBarBg, theme.panel);
  set_color(style, ImGuiCol_TitleBg, theme.panel);
  set_color(style, ImGuiCol_TitleBgActive, theme.panel);
  set_color(style, ImGuiCol_ScrollbarBg, with_alpha(theme.panel, 0));
  set_color(style, ImGuiCol_ScrollbarGrab, with_alpha(theme.dim_text, 0.35f));
  set_color(style, ImGuiCol_ScrollbarGrabHovered, with_alpha(theme.dim_text, 0.6f));
  set_color(style, ImGuiCol_ScrollbarGrabActive, with_alpha(theme.dim_text, 0.8f));
  set_color(style, ImGuiCol_Separator, theme.line);
  set_color(style, ImGuiCol_SeparatorHovered, theme.accent);
  set_color(style, ImGuiCol_SeparatorActive, theme.accent);
  set_color(style, ImGuiCol_TableBorderStrong, theme.line);
  set_color(style, ImGuiCol_TableBorderLight, theme.line);
  set_color(style, ImGuiCol_TableHeaderBg, theme.panel);
  set_color(style, ImGuiCol_TreeLines, theme.line);
  set_color(style, ImGuiCol_ModalWindowDimBg, with_alpha(IM_COL32_BLACK, 0.35f));
  set_color(style, ImGuiCol_NavWindowingDimBg, with_alpha(IM_COL32_BLACK, 0.2f));
}

void set_control_colors(ImGuiStyle& style, const Theme& theme) {
  set_color(style, ImGuiCol_FrameBg, theme.raised);
  set_color(style, ImGuiCol_FrameBgHovered, theme.hovered);
  set_color(style, ImGuiCol_FrameBgActive, theme.pressed);
  set_color(style, ImGuiCol_Button, theme.raised);
  set_color(style, ImGuiCol_ButtonHovered, theme.hovered);
  set_color(style, ImGuiCol_ButtonActive, theme.pressed);
  set_color(style, ImGuiCol_Header, theme.hovered);
  set_color(style, ImGuiCol_HeaderHovered, theme.hovered);
  set_color(style, ImGuiCol_HeaderActive, theme.pressed);
  set_color(style, ImGuiCol_CheckMark, theme.accent);
  set_color(style, ImGuiCol_SliderGrab, theme.accent);
  set_color(style, ImGuiCol_SliderGrabActive, theme.accent);
  set_color(style, ImGuiCol_InputTextCursor, theme.accent);
  set_color(style, ImGuiCol_TextSelectedBg, with_alpha(theme.accent, 0.35f));
  set_color(style, ImGuiCol_TextLink, theme.accent);
  set_color(style, ImGuiCol_NavCursor, theme.accent);
  set_color(style, ImGuiCol_NavWindowingHighlight, theme.accent);
  set_color(style, ImGuiCol_DragDropTarget, theme.accent);
}

}  // namespace

Theme make_theme(ThemeKind kind) { return kind == ThemeKind::Dark ? make_dark_theme() : make_light_theme(); }

Theme with_more_contrast(Theme theme) {
  const bool dark = theme.kind == ThemeKind::Dark;
  theme.text = dark ? rgb(0xFFFFFF) : rgb(0x000000);
  theme.dim_text = dark ? rgb(0xC9D0D9) : rgb(0x363D46);
  theme.line = dark ? rgb(0x4A515C) : rgb(0xB4BCC7);
  theme.grid = dark ? rgb(0x6A7380) : rgb(0x87919F);
  theme.ghost = dark ? rgb(0xA3ACB8) : rgb(0x737D8A);
  return theme;
}

void apply_theme(const Theme& theme, bool touch) {
  ImGuiStyle& style = ImGui::GetStyle();
  set_measures(style, touch);
  const float density = std::max(ImGui::GetIO().DisplayFramebufferScale.x, 0.5f);
  style.WindowBorderSize = style.PopupBorderSize = 1.0f / density;
  set_surface_colors(style, theme);
  set_control_colors(style, theme);
}

ImU32 with_alpha(ImU32 color, float alpha) {
  const auto own = static_cast<float>((color >> IM_COL32_A_SHIFT) & 255U);
  const auto scaled = static_cast<ImU32>(own * std::clamp(alpha, 0.0f, 1.0f) + 0.5f);
  return (color & ~IM_COL32_A_MASK) | (scaled << IM_COL32_A_SHIFT);
}

}  // namespace marey::app
