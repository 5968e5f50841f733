#include "wasm/views/shortcut_sheet.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "wasm/app/shortcut.h"
#include "wasm/app/widgets.h"
#include "wasm/views/overlay_window.h"

namespace marey::app {
namespace {

constexpr float kPadding = 20.0f;
constexpr float kRowHeight = 28.0f;
constexpr float kColumnWidth = 300.0f;
constexpr float kColumnGap = 32.0f;

struct Group {
  std::string_view prefix;
  std::string_view title;
};

constexpr Group kGroups[] = {{"play.", "Playing"}, {"curve.", "Curves"},      {"select.", "Joints"}, {"edit.", "Edit"},
                             {"view.", "View"},    {"camera.", "Camera"},     {"file.", "File"},     {"help.", "Help"}};

std::vector<const Command*> commands_of(const CommandRegistry& registry, std::string_view prefix) {
  std::vector<const Command*> commands;
  for (const Command& command : registry.all()) {
    if (command.id.starts_with(prefix) && !command.shortcut.empty()) commands.push_back(&command);
  }
  return commands;
}

// Each key of "Ctrl Shift Z" on a cap of its own.
void draw_keys(const ViewContext& context, const std::string& keys, float right, float y) {
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  std::string rest = keys;
  while (!rest.empty()) {
    const std::size_t blank = rest.rfind(' ');
    const std::string key = blank == std::string::npos ? rest : rest.substr(blank + 1);
    rest = blank == std::string::npos ? std::string() : rest.substr(0, blank);
    const float width = std::max(22.0f, std::ceil(ImGui::CalcTextSize(key.c_str()).x) + 12.0f);
    const ImVec2 min(right - width, y + 3.0f);
    const ImVec2 max(right, y + kRowHeight - 3.0f);
    draw_list.AddRectFilled(min, max, context.theme.raised, 4.0f);
    draw_list.AddRect(min, max, context.theme.line, 4.0f, 0, ui::device_pixel());
    const float text_x = std::round((min.x + max.x - ImGui::CalcTextSize(key.c_str()).x) * 0.5f);
    draw_list.AddText(ImVec2(text_x, std::round((min.y + max.y - Fonts::kTextSize) * 0.5f)), context.theme.text, key.c_str());
    right = min.x - 4.0f;
  }
}

void draw_group(ViewContext& context, const Group& group, const std::vector<const Command*>& commands, float width) {
  ImGui::BeginGroup();
  ImGui::PushFont(context.fonts.semibold, 0.0f);
  ui::dim_text(context, group.title);
  ImGui::PopFont();
  for (const Command* command : commands) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddText(ImVec2(at.x, at.y + std::round((kRowHeight - Fonts::kTextSize) * 0.5f)),
                                        context.theme.text, command->label.c_str());
    draw_keys(context, displayed_shortcut(command->shortcut, context.system.apple_keys), at.x + width, at.y);
    ImGui::Dummy(ImVec2(width, kRowHeight));
    context.items.add_last("shortcuts." + command->id, command->label);
  }
  ImGui::Dummy(ImVec2(0.0f, 12.0f));
  ImGui::EndGroup();
}

// Fills columns from left to right with whole groups.
void draw_groups(ViewContext& context, int columns, float width) {
  float total = 0.0f;
  for (const Group& group : kGroups) total += kRowHeight * static_cast<float>(commands_of(context.commands, group.prefix).size() + 1);
  const float column_height = total / static_cast<float>(columns);
  float filled = 0.0f;
  ImGui::BeginGroup();
  for (const Group& group : kGroups) {
    const auto commands = commands_of(context.commands, group.prefix);
    if (commands.empty()) continue;
    if (filled > 0.0f && filled >= column_height * 0.85f) {
      ImGui::EndGroup();
      ImGui::SameLine(0.0f, kColumnGap);
      ImGui::BeginGroup();
      filled = 0.0f;
    }
    draw_group(context, group, commands, width);
    filled += kRowHeight * static_cast<float>(commands.size() + 1);
  }
  ImGui::EndGroup();
}

}  // namespace

void ShortcutSheet::draw(ViewContext& context, bool& open) {
  const float page = ImGui::GetIO().DisplaySize.x;
  const int columns = std::clamp(static_cast<int>((page - 80.0f) / (kColumnWidth + kColumnGap)), 1, 3);
  const auto count = static_cast<float>(columns);
  const float wanted = count * kColumnWidth + (count - 1.0f) * kColumnGap + 2.0f * kPadding + 12.0f;
  begin_overlay(context, {"##shortcuts", ImVec2(wanted, 620.0f), 0.5f}, open);
  draw_overlay_title(context, "Keyboard shortcuts", "shortcuts.close", open);
  ImGui::SetCursorPosX(kPadding);
  ImGui::BeginChild("groups", ImVec2(ImGui::GetWindowWidth() - 2.0f * kPadding + 12.0f, ImGui::GetContentRegionAvail().y - 12.0f),
                    ImGuiChildFlags_NavFlattened);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 0.0f));
  const float inner = ImGui::GetContentRegionAvail().x - 12.0f;
  draw_groups(context, columns, std::floor((inner - kColumnGap * (count - 1.0f)) / count));
  ImGui::PopStyleVar();
  ImGui::EndChild();
  end_overlay();
}

}  // namespace marey::app
