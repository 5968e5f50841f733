#pragma once

#include "wasm/app/performance.h"
#include "wasm/app/view_context.h"

namespace marey::app {

/// In the upper left corner of the viewport: what the last frames took, as numbers and as a graph. Takes no input and asks
/// for no frame: an idle page shows the last numbers. `corner`: of the viewport, screen; `size`: its extent.
void draw_performance_card(ViewContext& context, const Performance& performance, ImVec2 corner, ImVec2 size);

}  // namespace marey::app
