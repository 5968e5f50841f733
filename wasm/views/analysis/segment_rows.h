#pragma once

#include "core/biomechanics/chosen_body.h"
#include "wasm/app/view_context.h"

namespace marey::app {

/// Makes a choice of the body an edit; a refusal is said in the status line.
void apply_body(ViewContext& context, const BodyChoice& body);

/// What the selected joint carries: its part, and mass, centre of mass and inertia, which can be typed in.
void draw_carried_segment(ViewContext& context);

/// The masses of all segments; a click on a name selects the joint.
void draw_segment_list(ViewContext& context, const ChosenBody& body);

/// Open a model, save it.
void draw_model_buttons(ViewContext& context);

}  // namespace marey::app
