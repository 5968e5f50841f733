#pragma once

#include "wasm/app/view_context.h"
#include "wasm/views/curves/curves_state.h"

namespace marey::app {

/// Pointer and keys over the canvas of the curve editor. Call with the canvas as the last ImGui item.
///
/// Left: click selects (Shift adds, Ctrl toggles), drag from a sample moves the selection in value, drag from empty
/// space selects with a box, drag from the frame cursor scrubs. Middle or Alt+left: pan. Right: zoom both axes.
/// Wheel: zoom time; Ctrl+wheel: zoom values; Shift+wheel: pan in time; wheel during a move: falloff radius.
/// Escape takes a move back. Double click fits.
void handle_curves_input(ViewContext& context, CurvesState& state);

/// Wheel and drags over the gutter of a value axis zoom that axis alone.
void handle_axis_input(ViewContext& context, ValueAxis& axis);

}  // namespace marey::app
