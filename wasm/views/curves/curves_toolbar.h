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
  /// What the fields show of the selected samples, and what it was computed from.
  struct SelectionFacts {
    std::uint64_t clip_serial = 0;
    std::uint64_t revision = 0;
    std::uint64_t sample_serial = 0;
    const char* unit = nullptr;  ///< nothing before the first
    double mean = 0.0;
  };

  void follow_selection(const ViewContext& context);
  void draw_value(ViewContext& context);
  void draw_offset(ViewContext& context);
  void draw_scale(ViewContext& context);
  void draw_smooth(ViewContext& context);

  SelectionFacts facts_;
  double offset_ = 0.0;
  double scale_ = 1.0;
};

}  // namespace marey::app
