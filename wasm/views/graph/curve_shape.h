#pragma once

#include <imgui.h>

#include <span>
#include <vector>

#include "wasm/app/time_window.h"
#include "wasm/render/curve_batch.h"
#include "wasm/views/graph/dashes.h"
#include "wasm/views/graph/value_axis.h"

namespace marey::app {

/// The visible samples of a curve as screen points, for curves with few samples to a pixel; those with more are drawn as
/// CurveBand. Samples that are not finite break the curve: each unbroken stretch is one strip.
class CurveShape {
 public:
  struct Strip {
    int first = 0;
    int count = 0;
  };

  /// `samples` are the whole curve; the visible frames come from `time`. Buffers are reused.
  void build(std::span<const double> samples, const TimeWindow& time, const ValueAxis& axis);

  [[nodiscard]] std::span<const Strip> strips() const { return strips_; }
  [[nodiscard]] std::span<const ImVec2> points(const Strip& strip) const;

  void draw(ImDrawList& list, ImU32 color, float width, Dashes dashes = {}) const;
  /// The same for a batch of lines.
  void add_to(CurveBatch& batch, ImU32 color, float width) const;

 private:
  void add_point(ImVec2 point);

  std::vector<ImVec2> points_;
  std::vector<Strip> strips_;
  bool open_ = false;
};

}  // namespace marey::app
