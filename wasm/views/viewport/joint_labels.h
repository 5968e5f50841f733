#pragma once

#include <imgui.h>

#include <span>
#include <string>
#include <vector>

#include "wasm/app/view_context.h"
#include "wasm/views/viewport/viewport_state.h"

namespace marey::app {

/// A label that would like to stand beside `anchor`, on the right of it or first on the left.
struct LabelWish {
  ImVec2 anchor;
  ImVec2 size;
  bool left_first = false;
};

/// Where a label stands; `wish` is its index.
struct LabelPlace {
  int wish = 0;
  ImVec2 min;
};

/// Places labels one after the other, each beside, above or below its anchor where it overlaps none placed before and
/// lies within [low, high]; those without room are left out. `gap`: from the anchor.
void place_labels(std::span<const LabelWish> wishes, ImVec2 low, ImVec2 high, float gap,
                  std::vector<LabelPlace>& places);

/// Names in the view: of all joints as far as there is room, and of the joint under the pointer.
class JointLabels {
 public:
  void draw(ViewContext& context, const ViewportState& state);

 private:
  struct Name {
    JointIndex joint = 0;
    std::string text;   // shortened, for the overlay
    ImVec2 size;
  };

  void update_names(const ViewContext& context, const ViewportState& state);
  void draw_names(ViewContext& context, const ViewportState& state);

  std::vector<Name> names_;  // in the order in which they are placed
  std::vector<LabelWish> wishes_;
  std::vector<int> wishing_;  // index into names_ per wish
  std::vector<LabelPlace> places_;
  std::uint64_t figure_serial_ = 0;
};

}  // namespace marey::app
