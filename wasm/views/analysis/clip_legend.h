#pragma once

#include "wasm/app/view_context.h"

namespace marey::app {

/// Which clip the plots draw with which kind of line, and a button that takes it away; nothing without other clips. Returns its
/// height.
float draw_clip_legend(ViewContext& context, ImVec2 min, float width);

}  // namespace marey::app
