#include <algorithm>
#include <cmath>

#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"

namespace marey::app::ui {
namespace {

constexpr float kPadding = 8.0f;
constexpr float kListPadding = 4.0f;
constexpr float kMarkColumn = 24.0f;

float text_top(ImVec2 min, ImVec2 max) { return std::round((min.y + max.y - Fonts::kTextSize) * 0.5f); }

void draw_field(const ViewContext& context, std::string_view shown) {
  const Theme& theme = context.theme;
  const ImVec2 min = ImGui::GetItemRectMin();
  const ImVec2 max = ImGui::GetItemRectMax();
  const bool touched = ImGui::IsItemHovered() || ImGui::IsItemActive();
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  draw_list.AddRectFilled(min, max, touched ? theme.hovered : theme.raised, 4.0f);
  draw_list.AddRect(min, max, theme.line, 4.0f, 0, device_pixel());
  draw_list.AddText(ImVec2(min.x + kPadding, text_top(min, max)), theme.text, shown.data(),
                    shown.data() + shown.size());
  draw_list.AddText(ImVec2(max.x - kPadding - Fonts::kTextSize + 2.0f, text_top(min, max)), theme.dim_text,
                    icons::kChevronDown);
}

bool draw_option(ViewContext& context, const ChoiceOption& option, bool chosen, float width) {
  const bool pressed = ImGui::InvisibleButton(option.id.c_str(), ImVec2(width, ImGui::GetFrameHeight()),
                                              ImGuiButtonFlags_EnableNav);
  const ImVec2 min = ImGui::GetItemRectMin();
  const ImVec2 max = ImGui::GetItemRectMax();
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) draw_list.AddRectFilled(min, max, context.theme.hovered, 4.0f);
  if (chosen) draw_list.AddText(ImVec2(min.x + 4.0f, text_top(min, max)), context.theme.accent, icons::kCheck);
  draw_list.AddText(ImVec2(min.x + kMarkColumn, text_top(min, max)), context.theme.text, option.label.c_str());
  context.items.add_last(option.id, option.label);
  return pressed;
}

// Below the field, or above it where the page ends.
void place_list(ImVec2 field_min, ImVec2 field_max, int options) {
  const float page = ImGui::GetIO().DisplaySize.y;
  const float height = static_cast<float>(options) * ImGui::GetFrameHeight() + 2.0f * kListPadding;
  const bool fits_below = field_max.y + 4.0f + height <= page - 8.0f;
  const float top = fits_below ? field_max.y + 4.0f : std::max(8.0f, field_min.y - 4.0f - height);
  ImGui::SetNextWindowPos(ImVec2(field_min.x, top));
  ImGui::SetNextWindowSizeConstraints(ImVec2(0.0f, 0.0f), ImVec2(1e4f, page - top - 8.0f));
}

}  // namespace

bool choice(ViewContext& context, const char* id, std::string_view label, std::string_view tip,
            std::span<const ChoiceOption> options, int& chosen, float width) {
  const SmallText list_id("##{}.list", id);
  if (ImGui::InvisibleButton(id, ImVec2(width, ImGui::GetFrameHeight()), ImGuiButtonFlags_EnableNav)) {
    ImGui::OpenPopup(list_id.c_str());
  }
  const bool is_known = chosen >= 0 && chosen < size_of(options);
  draw_field(context, is_known ? std::string_view(options[idx(chosen)].label) : std::string_view());
  context.items.add_last(id, label);
  tool_tip(context, label, tip);

  place_list(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), size_of(options));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(kListPadding, kListPadding));
  const bool open = ImGui::BeginPopup(list_id.c_str(), ImGuiWindowFlags_NoMove);
  ImGui::PopStyleVar();
  if (!open) return false;
  popup_shadow(context);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 0.0f));
  int pressed = -1;
  for (int i = 0; i < size_of(options); ++i) {
    if (draw_option(context, options[idx(i)], i == chosen, std::max(width, 96.0f))) pressed = i;
  }
  ImGui::PopStyleVar();
  if (pressed >= 0) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  if (pressed < 0 || pressed == chosen) return false;
  chosen = pressed;
  return true;
}

}  // namespace marey::app::ui
