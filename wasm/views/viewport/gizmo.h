#pragma once

#include <array>

#include "wasm/app/view_context.h"
#include "wasm/views/viewport/viewport_state.h"

namespace marey::app {

/// A direction to look from along a world axis, with its name: "Front", "Top" ...
struct AxisView {
  const char* name = "";
  const char* command = "";  ///< "view.front"
  double yaw_rad = 0.0;
  double pitch_rad = 0.0;
};

/// Front, back, side (+X), opposite side, top, bottom.
extern const std::array<AxisView, 6> kAxisViews;

/// The view along an axis that a camera holds, to half a degree; nullptr for any other direction.
[[nodiscard]] const AxisView* find_axis_view(const CameraPose& pose);

/// The view that looks at the figure from the positive or negative end of a world axis.
[[nodiscard]] const AxisView& axis_view_from(Axis axis, bool negative, Axis up);

/// Side of the square that the gizmo takes, ImGui units.
[[nodiscard]] float gizmo_size(const ViewContext& context);

/// Draws the world axes as seen by the camera, with its top right at `corner`; a click on an end looks from there.
void draw_gizmo(ViewContext& context, ViewportState& state, ImVec2 top_right);

}  // namespace marey::app
