#pragma once

#include <imgui.h>

#include <string>
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
  void begin_frame() { items_.clear(); }
  /// Records a rectangle, clipped to the current ImGui clip rectangle; nothing is recorded when nothing is visible.
  void add(std::string id, std::string label, ImVec2 min, ImVec2 max);
  /// Records the last ImGui item.
  void add_last(std::string id, std::string label);
  [[nodiscard]] const std::vector<UiItem>& list() const { return items_; }

 private:
  std::vector<UiItem> items_;
};

}  // namespace marey::app
