#pragma once

#include <functional>
#include <string>
#include <vector>

#include "wasm/app/view_context.h"

namespace marey::app {

/// One of several ways to read a file.
struct ChoiceCard {
  std::string id;      ///< of the item, "clip.up_axis.z@inspector"
  std::string label;   ///< "Z is up"
  std::string detail;  ///< what comes of it: "1.72 m tall"
  std::string help;    ///< for the tool tip
  bool chosen = false;
  std::string blocked{};                             ///< why it cannot be chosen; "" when it can
  std::function<void(ImVec2 min, ImVec2 max)> draw_picture{};  ///< above the texts; none when empty
};

/// Draws the cards in rows, as many beside each other as fit the panel. Returns the index of the card that was pressed, -1
/// for none; the chosen one does not count.
int draw_choice_cards(ViewContext& context, const std::vector<ChoiceCard>& cards);

}  // namespace marey::app
