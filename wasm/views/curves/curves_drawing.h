#pragma once

#include "wasm/app/view_context.h"
#include "wasm/views/curves/curves_state.h"
#include "wasm/views/graph/curve_shape.h"

namespace marey::app {

/// Draws the canvas of the curve editor: grid, ghosts of the saved curves, curves, samples, selection, drag aids, frame
/// cursor with the values at it. Changes nothing but its scratch buffers.
class CurvesDrawing {
 public:
  void draw(ViewContext& context, const CurvesState& state);

 private:
  void draw_ghost(ViewContext& context, const CurvesState& state, ChannelIndex channel);
  void draw_curve(ViewContext& context, const CurvesState& state, ChannelIndex channel);
  void draw_strips(ImDrawList& list, ImU32 color, float width);

  CurveShape shape_;
};

/// Colour of a channel's curve: that of its axis.
[[nodiscard]] ImU32 channel_color(const Theme& theme, const Channel& channel);

}  // namespace marey::app
