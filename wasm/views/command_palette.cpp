#include "wasm/views/command_palette.h"

#include <imgui_internal.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "core/base/stable_order.h"
#include "wasm/app/fuzzy_match.h"
#include "wasm/app/icons.h"
#include "wasm/app/shortcut.h"
#include "wasm/app/widgets.h"
#include "wasm/views/overlay_window.h"

namespace marey::app {
namespace {

constexpr float kWidth = 560.0f;
constexpr float kHeight = 420.0f;
constexpr float kQueryHeight = 48.0f;
constexpr float kRowHeight = 34.0f;
constexpr float kInset = 8.0f;

// Text with the matched letters in semibold would jump while typing: they are coloured instead.
void draw_label(const ViewContext& context, const std::string& label, const std::vector<int>& matched, ImVec2 at,
                ImU32 color) {
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  draw_list.AddText(at, color, label.c_str());
  for (const int position : matched) {
    const char* letter = label.c_str() + position;
    const float x = at.x + ImGui::CalcTextSize(label.c_str(), letter).x;
    draw_list.AddText(ImVec2(x, at.y), context.theme.accent, letter, letter + 1);
  }
}

int ignore_history(ImGuiInputTextCallbackData* /*data*/) { return 0; }

}  // namespace

void CommandPalette::collect(const CommandRegistry& registry) {
  entries_.clear();
  for (const Command& command : registry.all()) {
    if (!command.in_palette) continue;
    const std::string label(CommandRegistry::label_of(command));
    if (auto match = find_fuzzy_match(query_, label)) {
      entries_.push_back({&command, match->score + 2, std::move(match->positions)});
    } else if (auto by_help = find_fuzzy_match(query_, command.id)) {
      entries_.push_back({&command, by_help->score - 20, {}});
    }
  }
  const auto better = [](const Entry& a, const Entry& b) { return a.score > b.score; };
  if (!query_.empty()) sort_stably(entries_, better);
}

// The field keeps the keyboard: asking for history keeps up and down from moving ImGui's focus away from it.
void CommandPalette::draw_query(ViewContext& context) {
  const ImVec2 corner = ImGui::GetWindowPos();
  ImGui::GetWindowDrawList()->AddText(ImVec2(corner.x + 16.0f, corner.y + std::round((kQueryHeight - Fonts::kTextSize) * 0.5f)),
                                      context.theme.dim_text, icons::kSearch);
  ImGui::SetCursorPos(ImVec2(38.0f, std::round((kQueryHeight - ImGui::GetFrameHeight()) * 0.5f)));
  ImGui::SetNextItemWidth(ImGui::GetWindowWidth() - 54.0f);
  if (ImGui::IsWindowAppearing()) {
    query_.clear();
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::PushStyleColor(ImGuiCol_FrameBg, with_alpha(context.theme.panel, 0.0f));
  const std::string before = query_;
  entered_ = ImGui::InputTextWithHint("##query", "Search commands", &query_,
                                      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory,
                                      ignore_history);
  ImGui::PopStyleColor();
  context.items.add_last("palette.query", "Search commands");
  if (query_ != before || ImGui::IsWindowAppearing()) {
    chosen_ = 0;
    scroll_to_chosen_ = true;
  }
  ui::hairline(*ImGui::GetWindowDrawList(), ImVec2(corner.x, corner.y + kQueryHeight),
               ImVec2(corner.x + ImGui::GetWindowWidth(), corner.y + kQueryHeight), context.theme.line);
}

void CommandPalette::follow_keys() {
  const int count = size_of(entries_);
  int moved = 0;
  if (ImGui::IsKeyPressed(ImGuiKey_DownArrow)) moved = 1;
  if (ImGui::IsKeyPressed(ImGuiKey_UpArrow)) moved = -1;
  if (ImGui::IsKeyPressed(ImGuiKey_PageDown)) moved = 8;
  if (ImGui::IsKeyPressed(ImGuiKey_PageUp)) moved = -8;
  if (moved != 0) scroll_to_chosen_ = true;
  chosen_ = std::clamp(chosen_ + moved, 0, std::max(0, count - 1));
}

bool CommandPalette::draw_entry(ViewContext& context, const Entry& entry, bool chosen) {
  const Command& command = *entry.command;
  const Theme& theme = context.theme;
  const std::string_view reason = CommandRegistry::blocked_reason(command);
  const std::string id = "palette." + command.id;
  const bool pressed = ImGui::InvisibleButton(id.c_str(), ImVec2(ImGui::GetContentRegionAvail().x, kRowHeight));
  const ImVec2 min = ImGui::GetItemRectMin();
  const ImVec2 max = ImGui::GetItemRectMax();
  if (chosen && scroll_to_chosen_) ImGui::SetScrollHereY(0.5f);
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  if (chosen || ImGui::IsItemHovered()) {
    draw_list.AddRectFilled(min, max, chosen ? with_alpha(theme.accent, 0.18f) : theme.hovered, 6.0f);
  }
  const float y = std::round((min.y + max.y - Fonts::kTextSize) * 0.5f);
  const ImU32 color = with_alpha(theme.text, reason.empty() ? 1.0f : 0.5f);
  const bool on = command.checked && command.checked();
  const char* icon = on ? icons::kCheck : CommandRegistry::icon_of(command);
  if (icon != nullptr) draw_list.AddText(ImVec2(min.x + 10.0f, y), on ? theme.accent : theme.dim_text, icon);
  draw_label(context, std::string(CommandRegistry::label_of(command)), entry.positions, ImVec2(min.x + 38.0f, y), color);
  const std::string right = reason.empty() ? displayed_shortcut(command.shortcut, context.system.apple_keys) : std::string(reason);
  const float width = ImGui::CalcTextSize(right.c_str()).x;
  draw_list.AddText(ImVec2(max.x - 10.0f - width, y), reason.empty() ? theme.dim_text : theme.warning, right.c_str());
  context.items.add_last(id, CommandRegistry::label_of(command));
  return pressed;
}

void CommandPalette::draw_entries(ViewContext& context, bool& open) {
  ImGui::SetCursorPos(ImVec2(kInset, kQueryHeight + kInset));
  ImGui::BeginChild("entries", ImVec2(ImGui::GetWindowWidth() - 2.0f * kInset, ImGui::GetWindowHeight() - kQueryHeight - 2.0f * kInset));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 0.0f));
  const Command* run = nullptr;
  for (int i = 0; i < size_of(entries_); ++i) {
    if (draw_entry(context, entries_[idx(i)], i == chosen_)) run = entries_[idx(i)].command;
  }
  if (entries_.empty()) {
    ImGui::SetCursorPos(ImVec2(10.0f, 10.0f));
    ui::dim_text(context, "No command has these letters. Try a shorter word.");
  } else if (entered_) {
    run = entries_[idx(chosen_)].command;
  }
  scroll_to_chosen_ = false;
  ImGui::PopStyleVar();
  ImGui::EndChild();
  if (run == nullptr || !CommandRegistry::is_enabled(*run)) return;
  open = false;
  const std::string id = run->id;
  context.commands.run(id);
}

void CommandPalette::draw(ViewContext& context, bool& open) {
  begin_overlay(context, {"##palette", ImVec2(kWidth, kHeight), 0.18f}, open);
  draw_query(context);
  collect(context.commands);
  follow_keys();
  draw_entries(context, open);
  end_overlay();
}

}  // namespace marey::app
