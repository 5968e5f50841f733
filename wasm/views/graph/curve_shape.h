#pragma once

#include <imgui.h>

#include <span>
#include <vector>

#include "wasm/app/time_window.h"
#include "wasm/views/graph/value_axis.h"

namespace marey::app {

/// Turns the visible part of a curve into screen points. Where several samples share a column of `column_width`, the
/// column keeps its first, lowest, highest and last sample, so that no peak is lost and the cost is that of the pixels.
/// Samples that are not finite break the curve: each unbroken stretch is one strip.
class CurveShape {
 public:
  struct Strip {
    int first = 0;
    int count = 0;
  };

  /// `samples` are the whole curve; the visible frames come from `time`. Buffers are reused.
  void build(std::span<const double> samples, const TimeWindow& time, const ValueAxis& axis, float column_width = 1.0f);

  [[nodiscard]] std::span<const Strip> strips() const { return strips_; }
  [[nodiscard]] std::span<const ImVec2> points(const Strip& strip) const;

 private:
  void add_point(ImVec2 point);
  void break_strip();
  void add_samples(std::span<const double> samples, int first, int last, const TimeWindow& time, const ValueAxis& axis);
  void add_columns(std::span<const double> samples, int first, int last, const TimeWindow& time, const ValueAxis& axis,
                   double frames_per_column);

  std::vector<ImVec2> points_;
  std::vector<Strip> strips_;
  bool open_ = false;
};

}  // namespace marey::app
