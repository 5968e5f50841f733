#pragma once

#include "wasm/app/view_context.h"

namespace marey::app {

/// The row of a narrow page that opens and closes its sheet: curves, joints or inspector.
void draw_sheet_tabs(ViewContext& context);

}  // namespace marey::app
