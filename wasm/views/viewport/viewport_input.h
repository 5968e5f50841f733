#pragma once

#include "wasm/app/view_context.h"
#include "wasm/views/viewport/viewport_state.h"

namespace marey::app {

/// Takes the pointer over the last ImGui item, which covers the view: a drag orbits (left, middle) or pans (right,
/// Shift+middle, two fingers), the wheel zooms to the pointer, a click selects a joint, Shift or Ctrl adds or removes
/// it, a click on nothing clears. Writes hover and status.
void handle_viewport_input(ViewContext& context, ViewportState& state);

}  // namespace marey::app
