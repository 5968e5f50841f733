#pragma once

#include <imgui.h>

#include <span>
#include <vector>

#include "core/motion/curve_pyramid.h"
#include "wasm/app/time_window.h"
#include "wasm/render/curve_batch.h"
#include "wasm/views/graph/dashes.h"
#include "wasm/views/graph/value_axis.h"

namespace marey::app {

/// The columns of one ImGui unit that the visible part of a curve of `sample_count` samples has.
[[nodiscard]] CurveColumns visible_columns(const TimeWindow& time, int sample_count);

/// A curve with several samples to a pixel: a band through its columns, each from its highest to its lowest sample, so that
/// no peak is lost and the cost is that of the pixels. A broken column breaks the band. See
/// docs/decisions/drawing-curves.md.
class CurveBand {
 public:
  struct Column {
    float x = 0.0f;
    float top = 0.0f;
    float bottom = 0.0f;
  };
  struct Strip {
    int first = 0;
    int count = 0;
  };

  /// Buffers are reused. `extents` belong to `columns`.
  void build(std::span<const ValueExtent> extents, const CurveColumns& columns, const TimeWindow& time,
             const ValueAxis& axis);

  [[nodiscard]] std::span<const Strip> strips() const { return strips_; }
  [[nodiscard]] std::span<const Column> columns(const Strip& strip) const;

  /// A line through the middles of the columns.
  void draw_middle(ImDrawList& list, ImU32 color, float width, Dashes dashes);

  /// `width`: of the line that stands around the extents.
  void add_to(CurveBatch& batch, ImU32 color, float width) const;

 private:
  void add_column(const Column& column);
  void bridge_gaps();

  std::vector<Column> columns_;
  std::vector<Strip> strips_;
  std::vector<ImVec2> middles_;
  bool open_ = false;
};

}  // namespace marey::app
