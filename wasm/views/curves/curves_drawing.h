#pragma once

#include "wasm/app/view_context.h"
#include "wasm/views/curves/curve_lines.h"
#include "wasm/views/curves/curves_state.h"

namespace marey::app {

/// Draws the canvas of the curve editor: grid, ghosts of the saved curves, curves, samples, selection, drag aids, frame
/// cursor with the values at it. Changes nothing but its caches.
class CurvesDrawing {
 public:
  void draw(ViewContext& context, const CurvesState& state);

 private:
  CurveLines lines_;
};

}  // namespace marey::app
