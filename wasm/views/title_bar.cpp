#include "wasm/views/title_bar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "wasm/app/icons.h"
#include "wasm/app/shortcut.h"
#include "wasm/app/widgets.h"
#include "wasm/views/main_menu.h"
#include "wasm/views/menu.h"

namespace marey::app {
namespace {

constexpr float kPadding = 12.0f;
constexpr float kFileNameWidth = 240.0f;
constexpr float kDotRoom = 20.0f;
constexpr float kMenuPadding = 9.0f;
constexpr float kSearchWidth = 260.0f;
constexpr float kLeastSearchWidth = 150.0f;

float row_top() { return std::round((ImGui::GetWindowHeight() - ImGui::GetFrameHeight()) * 0.5f); }

void draw_program_name(const ViewContext& context) {
  const ImVec2 corner = ImGui::GetWindowPos();
  const float y = corner.y + std::round((ImGui::GetWindowHeight() - Fonts::kTitleSize) * 0.5f);
  ImGui::GetWindowDrawList()->AddText(context.fonts.semibold, Fonts::kTitleSize, ImVec2(corner.x + kPadding, y),
                                      context.theme.text, "Marey");
  const ImVec2 size = context.fonts.semibold->CalcTextSizeA(Fonts::kTitleSize, 1e6f, 0.0f, "Marey");
  ImGui::SetCursorPos(ImVec2(kPadding + std::ceil(size.x) + 16.0f, row_top()));
}

// File name, and a dot while it has changes that were not downloaded. Returns the width of the name.
float draw_file_name(ViewContext& context, float width) {
  const Document& document = context.session.document;
  const bool open = document.skeleton().joint_count() > 0;
  const std::string name = open ? ui::displayable(document.file_name()) : std::string("No file");
  ImGui::AlignTextToFramePadding();
  ui::elided_text(context, name, width - kDotRoom, open ? context.theme.text : context.theme.dim_text);
  context.items.add_last("title.file", name);
  const float name_width = ImGui::GetItemRectSize().x;
  if (!document.is_dirty()) return name_width;
  const ImVec2 end = ImGui::GetItemRectMax();
  const ImVec2 dot(end.x + 10.0f, ImGui::GetWindowPos().y + std::round(ImGui::GetWindowHeight() * 0.5f));
  ImGui::GetWindowDrawList()->AddCircleFilled(dot, 3.5f, context.theme.selection);
  ImGui::SetCursorScreenPos(ImVec2(dot.x - 6.0f, dot.y - 6.0f));
  ImGui::Dummy(ImVec2(12.0f, 12.0f));
  context.items.add_last("title.unsaved", "Not downloaded");
  if (ImGui::IsItemHovered()) {
    const std::string help = "Changed: " + describe(document.find_changes()) + ". This is only in this tab; Download keeps it.";
    ui::tool_tip(context, "Not downloaded", help, "Ctrl+S");
  }
  return name_width;
}

// Looks like a field, opens the palette.
void draw_search_box(ViewContext& context, float width) {
  const Command* command = context.commands.find("help.commands");
  if (command == nullptr) return;
  const bool pressed = ImGui::InvisibleButton("help.commands", ImVec2(width, ImGui::GetFrameHeight()), ImGuiButtonFlags_EnableNav);
  const ImVec2 min = ImGui::GetItemRectMin();
  const ImVec2 max = ImGui::GetItemRectMax();
  const Theme& theme = context.theme;
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  draw_list.AddRectFilled(min, max, ImGui::IsItemHovered() ? theme.hovered : theme.app, 4.0f);
  draw_list.AddRect(min, max, theme.line, 4.0f, 0, ui::device_pixel());
  const float y = std::round((min.y + max.y - Fonts::kTextSize) * 0.5f);
  draw_list.AddText(ImVec2(min.x + 8.0f, y), theme.dim_text, icons::kSearch);
  draw_list.AddText(ImVec2(min.x + 30.0f, y), theme.dim_text, "Search commands");
  const std::string keys = displayed_shortcut(command->shortcut, context.system.apple_keys);
  const float keys_width = ImGui::CalcTextSize(keys.c_str()).x;
  if (width > 190.0f) draw_list.AddText(ImVec2(max.x - 8.0f - keys_width, y), theme.dim_text, keys.c_str());
  context.items.add_last("help.commands", command->label);
  ui::command_tool_tip(context, *command);
  if (pressed) context.commands.run(command->id);
}

// Says beforehand in what the download will differ from the opened file.
void draw_download(ViewContext& context, bool with_label) {
  ui::command_button(context, "file.save", ui::ButtonLook::Primary, with_label);
  const Document& document = context.session.document;
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || document.skeleton().joint_count() == 0) return;
  const Changes changes = document.find_changes();
  context.status = changes.empty() ? "The download has the same clip as the opened file."
                                   : "The download differs in " + describe(changes) + ".";
}

float right_group_width(const ViewContext& context) {
  const float height = ImGui::GetFrameHeight();
  const float label = context.fonts.semibold->CalcTextSizeA(Fonts::kTextSize, 1e6f, 0.0f, "Download").x;
  return 2.0f * height + 4.0f + 12.0f + std::ceil(label + 42.0f) + kPadding;
}

}  // namespace

void TitleBar::draw_menu_button(ViewContext& context, int menu) {
  const MainMenu& entry = main_menus()[idx(menu)];
  const std::string title(entry.title);
  const std::string id = "menu." + title;
  const ImVec2 size(std::ceil(ImGui::CalcTextSize(title.c_str()).x) + 2.0f * kMenuPadding, ImGui::GetFrameHeight());
  const bool pressed = ImGui::InvisibleButton(id.c_str(), size, ImGuiButtonFlags_EnableNav);
  const ImVec2 min = ImGui::GetItemRectMin();
  const ImVec2 max = ImGui::GetItemRectMax();
  const bool pointed = ImGui::IsItemHovered() || (open_menu_ >= 0 && ImGui::IsMouseHoveringRect(min, max));
  const bool is_open = open_menu_ == menu;
  const std::string popup = "##popup." + title;
  // A pointer at rest does not take back what the arrow keys chose.
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  const bool entered = pointed && (moved.x != 0.0f || moved.y != 0.0f);
  if (pressed || (open_menu_ >= 0 && entered && !is_open)) {
    open_menu_ = menu;
    ImGui::OpenPopup(popup.c_str());
  }
  if (wanted_menu_ == menu) {
    open_menu_ = std::exchange(wanted_menu_, -1);
    ImGui::OpenPopup(popup.c_str());
  }
  if (pointed || is_open) {
    ImGui::GetWindowDrawList()->AddRectFilled(min, max, context.theme.hovered, ImGui::GetStyle().FrameRounding);
  }
  ImGui::GetWindowDrawList()->AddText(ImVec2(min.x + kMenuPadding, std::round((min.y + max.y - Fonts::kTextSize) * 0.5f)),
                                      context.theme.text, title.c_str());
  context.items.add_last(id, title);
  const bool shown = draw_menu_popup(context, popup.c_str(), ImVec2(min.x, max.y + 4.0f), entry.entries);
  if (!shown && open_menu_ == menu && !ImGui::IsPopupOpen(popup.c_str())) open_menu_ = -1;
}

// With a menu open, left and right go to its neighbours.
void TitleBar::follow_menu_keys() {
  if (open_menu_ < 0) return;
  const int count = size_of(main_menus());
  if (ImGui::IsKeyPressed(ImGuiKey_RightArrow)) wanted_menu_ = (open_menu_ + 1) % count;
  if (ImGui::IsKeyPressed(ImGuiKey_LeftArrow)) wanted_menu_ = (open_menu_ + count - 1) % count;
}

void TitleBar::draw_menus(ViewContext& context) {
  follow_menu_keys();
  for (int menu = 0; menu < size_of(main_menus()); ++menu) {
    draw_menu_button(context, menu);
    ImGui::SameLine(0.0f, 0.0f);
  }
}

void TitleBar::draw_wide(ViewContext& context) {
  const float width = ImGui::GetWindowWidth();
  const float right = width - right_group_width(context);
  draw_program_name(context);
  const float name_left = ImGui::GetCursorPosX();
  const float name_width = draw_file_name(context, std::clamp(width * 0.18f, 90.0f, kFileNameWidth));
  ImGui::SetCursorPos(ImVec2(name_left + name_width + kDotRoom + 8.0f, row_top()));
  draw_menus(context);
  const float free_left = ImGui::GetCursorPosX() + 12.0f;
  const float search = std::min(kSearchWidth, right - 16.0f - free_left);
  if (search >= kLeastSearchWidth) {
    ImGui::SetCursorPos(ImVec2(right - 16.0f - search, row_top()));
    draw_search_box(context, search);
  }
  ImGui::SetCursorPos(ImVec2(right, row_top()));
  ui::command_button(context, "edit.undo");
  ImGui::SameLine(0.0f, 4.0f);
  ui::command_button(context, "edit.redo");
  ImGui::SameLine(0.0f, 12.0f);
  draw_download(context, true);
}

void TitleBar::draw_compact(ViewContext& context) {
  const float height = ImGui::GetFrameHeight();
  const float right = ImGui::GetWindowWidth() - 4.0f * height - 8.0f - 4.0f;
  ImGui::SetCursorPos(ImVec2(4.0f, row_top()));
  if (ui::icon_button(context, "menu.all", icons::kMenu, "Menu. Every command of Marey.")) ImGui::OpenPopup("##all");
  draw_menu_popup(context, "##all", ImVec2(4.0f, ImGui::GetWindowHeight()), compact_menu());
  ImGui::SetCursorPos(ImVec2(height + 12.0f, row_top()));
  draw_file_name(context, right - height - 16.0f);
  ImGui::SetCursorPos(ImVec2(right, row_top()));
  for (const char* id : {"help.commands", "edit.undo", "edit.redo"}) {
    ui::command_button(context, id);
    ImGui::SameLine(0.0f, 0.0f);
  }
  ImGui::SameLine(0.0f, 4.0f);
  draw_download(context, false);
}

void TitleBar::draw(ViewContext& context, bool compact) { compact ? draw_compact(context) : draw_wide(context); }

}  // namespace marey::app
