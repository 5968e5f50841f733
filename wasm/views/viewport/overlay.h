#pragma once

#include "wasm/app/small_text.h"
#include "wasm/app/view_context.h"
#include "wasm/views/viewport/viewport_state.h"

namespace marey::app {

/// A round length that fits into a given room, with what stands beside it.
struct ScaleBar {
  double length = 1.0;  ///< file units
  float width = 0.0f;   ///< ImGui units
  SmallText label;      ///< "10 units = 0.55 m"
};

/// `units_per_pixel` > 0; the bar is at most `widest` ImGui units long.
[[nodiscard]] ScaleBar make_scale_bar(double units_per_pixel, float widest, double metres_per_unit);

/// "Front, orthographic"; the direction is left out where it is no named one.
[[nodiscard]] SmallText view_name(const CameraPose& pose);

/// Draws what lies over the scene at the edges: view name top left, gizmo and buttons top right, scale bar bottom left,
/// status line bottom right.
void draw_overlay(ViewContext& context, ViewportState& state);

}  // namespace marey::app
