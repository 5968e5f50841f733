#include "wasm/views/sheet_tabs.h"

#include <array>
#include <cmath>
#include <string>

#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

void draw_tab(ViewContext& context, const Command& command, ImVec2 size) {
  const bool active = command.checked && command.checked();
  const bool pressed = ImGui::InvisibleButton(("tab." + command.id).c_str(), size, ImGuiButtonFlags_EnableNav);
  const ImVec2 min = ImGui::GetItemRectMin();
  const ImVec2 max = ImGui::GetItemRectMax();
  const ImU32 color = active ? context.theme.accent : ImGui::IsItemHovered() ? context.theme.text : context.theme.dim_text;
  const float label_width = ImGui::CalcTextSize(command.label.c_str()).x;
  constexpr float kIcon = Fonts::kTextSize;
  constexpr float kGap = 8.0f;
  const float x = std::round((min.x + max.x - label_width - kIcon - kGap) * 0.5f);
  const float y = std::round((min.y + max.y - kIcon) * 0.5f);
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  draw_list.AddText(ImVec2(x, y), color, command.icon);
  draw_list.AddText(ImVec2(x + kIcon + kGap, y), color, command.label.c_str());
  if (active) draw_list.AddRectFilled(ImVec2(min.x + 16.0f, min.y), ImVec2(max.x - 16.0f, min.y + 2.0f), color);
  context.items.add_last("tab." + command.id, command.label);
  ui::command_tool_tip(context, command);
  if (pressed) context.commands.run(command.id);
}

}  // namespace

void draw_sheet_tabs(ViewContext& context) {
  constexpr std::array kTabs = {"view.curves", "view.outliner", "view.inspector"};
  const ImVec2 size(ImGui::GetWindowWidth() / static_cast<float>(kTabs.size()), ImGui::GetWindowHeight());
  for (const char* id : kTabs) {
    if (const Command* command = context.commands.find(id)) draw_tab(context, *command, size);
    ImGui::SameLine(0.0f, 0.0f);
  }
}

}  // namespace marey::app
