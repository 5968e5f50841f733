#pragma once

#include "wasm/app/view_context.h"

namespace marey::app {

/// The clip in numbers, and what Marey assumed of it: frame time, up axis, unit of length, meaning of positions. All
/// assumptions can be changed and undone.
void draw_clip_page(ViewContext& context);

namespace inspector {

/// Rows of the page that also stand below the findings they answer.
void draw_frame_time(ViewContext& context);
void draw_unit(ViewContext& context);
/// One button for each character set with some names as they would read; nothing where all names are ASCII.
void draw_names_choice(ViewContext& context);

}  // namespace inspector
}  // namespace marey::app
