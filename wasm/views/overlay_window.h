#pragma once

#include "wasm/app/view_context.h"

namespace marey::app {

/// A window above the panels: not modal, closed by a click beside it (or Escape, which the shell handles).
struct OverlayWindow {
  const char* name;       ///< of the ImGui window
  ImVec2 wanted_size;     ///< made smaller where the page is smaller
  float top_share = 0.5f; ///< where the free height is: 0 at the top, 0.5 centred
};

/// Opens the window. Always call end_overlay() afterwards. Sets `open` to false when the user clicked beside it.
void begin_overlay(const ViewContext& context, const OverlayWindow& window, bool& open);
void end_overlay();

/// Title row with a close button on its right end; `open` becomes false when it is pressed.
void draw_overlay_title(ViewContext& context, const char* title, const char* close_id, bool& open);

}  // namespace marey::app
