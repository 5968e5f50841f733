#include "wasm/app/ui_items.h"

#include <algorithm>
#include <utility>

#include <imgui_internal.h>

namespace marey::app {

void UiItems::add(std::string id, std::string label, ImVec2 min, ImVec2 max) {
  const ImRect clip = ImGui::GetCurrentWindowRead()->ClipRect;
  min = ImVec2(std::max(min.x, clip.Min.x), std::max(min.y, clip.Min.y));
  max = ImVec2(std::min(max.x, clip.Max.x), std::min(max.y, clip.Max.y));
  if (max.x <= min.x || max.y <= min.y) return;
  items_.push_back({std::move(id), std::move(label), min, max});
}

void UiItems::add_last(std::string id, std::string label) {
  add(std::move(id), std::move(label), ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

}  // namespace marey::app
