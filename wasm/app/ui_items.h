#pragma once

#include <imgui.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace marey::app {

/// A visible widget of the frame just drawn, in ImGui units.
struct UiItem {
  std::string id;  ///< stable: "timeline.play", "outliner.joint.3", "curves.canvas"
  std::string label;
  ImVec2 min;
  ImVec2 max;
};

/// Where every visible widget is, so that tests and embedding pages can click real pixels. Filled anew each frame.
class UiItems {
 public:
  void begin_frame() { count_ = 0; }
  /// Records a rectangle, clipped to the current ImGui clip rectangle; nothing is recorded when nothing is visible.
  void add(std::string_view id, std::string_view label, ImVec2 min, ImVec2 max);
  /// Records the last ImGui item.
  void add_last(std::string_view id, std::string_view label);
  [[nodiscard]] std::span<const UiItem> list() const { return std::span(items_).first(count_); }

 private:
  std::vector<UiItem> items_;  // those behind count_ are of earlier frames: their texts' memory is used again
  std::size_t count_ = 0;
};

}  // namespace marey::app
