#pragma once

#include "wasm/app/view_context.h"

namespace marey::app {

/// The channels of the selected joints beside the curves: colour, name, value at the frame, shown or hidden. Drawn into
/// the current child window.
void draw_channel_list(ViewContext& context);

}  // namespace marey::app
