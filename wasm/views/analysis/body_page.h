#pragma once

#include "wasm/app/view_context.h"

namespace marey::app {

/// The page of the inspector about mechanics: what the masses of the figure are and where they come from, what holds it, and
/// how velocities and accelerations are made.
void draw_body_page(ViewContext& context);

}  // namespace marey::app
