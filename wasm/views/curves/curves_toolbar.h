#pragma once

#include "wasm/app/view_context.h"
#include "wasm/views/curves/curves_state.h"

namespace marey::app {

/// The row above the curves: fit, falloff, and the operations on the selected samples: value, offset, scale, smooth.
class CurvesToolbar {
 public:
  [[nodiscard]] static float height();
  void draw(ViewContext& context, CurvesState& state);

 private:
  void draw_value(ViewContext& context);
  void draw_offset(ViewContext& context);
  void draw_scale(ViewContext& context);
  void draw_smooth(ViewContext& context);

  double offset_ = 0.0;
  double scale_ = 1.0;
};

}  // namespace marey::app
