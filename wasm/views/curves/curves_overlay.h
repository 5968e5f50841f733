#pragma once

#include "wasm/app/view_context.h"
#include "wasm/views/curves/curves_state.h"

/// What lies over or under the curves: shades, selection box, frame cursor and labels.
namespace marey::app {

/// Darkens the frames outside of the playback range and of the clip.
void draw_range_shade(ViewContext& context, const CurvesState& state);

/// During a drag: the frames that the falloff reaches, with its radius in words.
void draw_falloff_band(ViewContext& context, const CurvesState& state);

void draw_box(ViewContext& context, const CurvesState& state);

/// The frame cursor with each curve's value at it, decluttered.
void draw_cursor(ViewContext& context, const CurvesState& state);

/// The letter of each curve of the active joint at its right end: colour never tells them apart alone.
void draw_end_letters(ViewContext& context, const CurvesState& state);

/// Joint, channel, frame and value of what is under the pointer.
void draw_hit_label(ViewContext& context, const CurvesState& state);

}  // namespace marey::app
