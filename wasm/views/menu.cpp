#include "wasm/views/menu.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "wasm/app/icons.h"
#include "wasm/app/shortcut.h"
#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

constexpr float kIconColumn = 28.0f;
constexpr float kPadding = 10.0f;
constexpr float kShortcutGap = 32.0f;
constexpr float kLeastWidth = 220.0f;

bool is_heading(std::string_view entry) { return entry.starts_with('#'); }

float text_width(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; }

float row_width(const ViewContext& context, const Command& command) {
  const std::string keys = displayed_shortcut(command.shortcut, context.system.apple_keys);
  const float keys_width = keys.empty() ? 0.0f : kShortcutGap + text_width(keys);
  return kIconColumn + text_width(CommandRegistry::label_of(command)) + keys_width + 2.0f * kPadding;
}

float menu_width(const ViewContext& context, MenuEntries entries) {
  float width = kLeastWidth;
  for (const std::string_view entry : entries) {
    if (const Command* command = context.commands.find(entry)) width = std::max(width, row_width(context, *command));
  }
  return std::ceil(width);
}

void draw_line(const ViewContext& context, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ui::hairline(*ImGui::GetWindowDrawList(), ImVec2(at.x, at.y + 4.0f), ImVec2(at.x + width, at.y + 4.0f),
               context.theme.line);
  ImGui::Dummy(ImVec2(width, 9.0f));
}

void draw_heading(const ViewContext& context, std::string_view title) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddText(context.fonts.semibold, Fonts::kSmallSize, ImVec2(at.x + kPadding, at.y + 6.0f),
                                      context.theme.dim_text, title.data(), title.data() + title.size());
  ImGui::Dummy(ImVec2(0.0f, 24.0f));
}

// A toggle shows its state in the icon's place; it is the state that one looks for.
void draw_row_content(const ViewContext& context, const Command& command, bool enabled, ImVec2 min, ImVec2 max) {
  const Theme& theme = context.theme;
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const float y = std::round((min.y + max.y - Fonts::kTextSize) * 0.5f);
  const ImU32 text = with_alpha(theme.text, enabled ? 1.0f : 0.42f);
  const ImU32 dim = with_alpha(theme.dim_text, enabled ? 1.0f : 0.5f);
  const bool on = command.checked && command.checked();
  const char* icon = on ? icons::kCheck : command.checked ? nullptr : CommandRegistry::icon_of(command);
  if (icon != nullptr) draw_list.AddText(ImVec2(min.x + kPadding, y), on ? theme.accent : dim, icon);
  draw_list.AddText(ImVec2(min.x + kPadding + kIconColumn, y), text, CommandRegistry::label_of(command).c_str());
  const std::string keys = displayed_shortcut(command.shortcut, context.system.apple_keys);
  draw_list.AddText(ImVec2(max.x - kPadding - text_width(keys), y), dim, keys.c_str());
}

bool draw_row(ViewContext& context, const Command& command, float width) {
  const bool enabled = CommandRegistry::is_enabled(command);
  const std::string id = "menu." + command.id;
  const bool pressed =
      ImGui::InvisibleButton(id.c_str(), ImVec2(width, ImGui::GetFrameHeight()), ImGuiButtonFlags_EnableNav);
  const ImVec2 min = ImGui::GetItemRectMin();
  const ImVec2 max = ImGui::GetItemRectMax();
  if (ImGui::IsItemHovered() && enabled) {
    ImGui::GetWindowDrawList()->AddRectFilled(min, max, context.theme.hovered, ImGui::GetStyle().FrameRounding);
  }
  draw_row_content(context, command, enabled, min, max);
  context.items.add_last(id, CommandRegistry::label_of(command));
  ui::command_tool_tip(context, command);
  return pressed && enabled;
}

}  // namespace

void draw_menu(ViewContext& context, MenuEntries entries) {
  const float width = menu_width(context, entries);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 0.0f));
  std::string chosen;
  for (const std::string_view entry : entries) {
    if (entry.empty()) {
      draw_line(context, width);
    } else if (is_heading(entry)) {
      draw_heading(context, entry.substr(1));
    } else if (const Command* command = context.commands.find(entry)) {
      if (draw_row(context, *command, width)) chosen = command->id;
    }
  }
  ImGui::PopStyleVar();
  if (chosen.empty()) return;
  ImGui::CloseCurrentPopup();
  context.commands.run(chosen);
}

bool draw_menu_popup(ViewContext& context, const char* id, ImVec2 position, MenuEntries entries) {
  const ImVec2 page = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(position);
  ImGui::SetNextWindowSizeConstraints(ImVec2(0.0f, 0.0f), ImVec2(page.x - 16.0f, page.y - position.y - 8.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(4.0f, 4.0f));
  const bool open = ImGui::BeginPopup(id, ImGuiWindowFlags_NoMove);
  ImGui::PopStyleVar();
  if (!open) return false;
  ui::popup_shadow(context);
  draw_menu(context, entries);
  ImGui::EndPopup();
  return true;
}

}  // namespace marey::app
