#pragma once

#include <imgui.h>

#include <span>

namespace marey::app {

/// Lengths of strokes and gaps in turn, in units of the screen, an even number of them; empty: a line without gaps.
using Dashes = std::span<const float>;

/// Draws a line through points. The dashes go on from point to point, so that they are seen where these are close, too.
void stroke_dashed(ImDrawList& list, std::span<const ImVec2> points, ImU32 color, float width, Dashes dashes);

/// ImDrawList::PathStroke() in dashes.
void stroke_path(ImDrawList& list, ImU32 color, float width, Dashes dashes);

}  // namespace marey::app
