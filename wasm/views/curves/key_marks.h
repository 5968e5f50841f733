#pragma once

#include <imgui.h>

#include "core/motion/key_curve_edits.h"
#include "wasm/app/view_context.h"
#include "wasm/views/curves/curves_state.h"

namespace marey::app {

/// Keys of the active layer, or of the channels themselves, as diamonds on the curves that are shown; a key's own curve has
/// handles as well. The hovered or dragged key stands out.
void draw_key_marks(ViewContext& context, const CurvesState& state);

/// The key or handle under a point, nothing outside of a few units.
[[nodiscard]] KeyHit find_key_hit(const CurvesState& state, const Session& session, const TimeWindow& time, ImVec2 point);

/// Moves the grabbed key, or pulls the grabbed handle, to where the pointer is: time in whole frames unless Alt is held, one
/// step of undo for the whole drag.
void drag_key(ViewContext& context, CurvesState& state);

}  // namespace marey::app
