#include "wasm/app/ui_items.h"

#include <algorithm>

#include <imgui_internal.h>

namespace marey::app {

void UiItems::add(std::string_view id, std::string_view label, ImVec2 min, ImVec2 max) {
  const ImRect clip = ImGui::GetCurrentWindowRead()->ClipRect;
  min = ImVec2(std::max(min.x, clip.Min.x), std::max(min.y, clip.Min.y));
  max = ImVec2(std::min(max.x, clip.Max.x), std::min(max.y, clip.Max.y));
  if (max.x <= min.x || max.y <= min.y) return;
  if (count_ == items_.size()) items_.emplace_back();
  UiItem& item = items_[count_++];
  item.id = id;
  item.label = label;
  item.min = min;
  item.max = max;
}

void UiItems::add_last(std::string_view id, std::string_view label) {
  add(id, label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

}  // namespace marey::app
