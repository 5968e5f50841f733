#pragma once

#include <span>

namespace marey::app {

/// Vertical axis of a graph: the stretch of values shown between the lower and the upper edge.
struct ValueAxis {
  double low = -1.0;
  double high = 1.0;
  float top = 0.0f;     ///< screen y of `high`, ImGui units
  float bottom = 1.0f;  ///< screen y of `low`

  bool operator==(const ValueAxis&) const = default;

  [[nodiscard]] float y_of(double value) const;
  [[nodiscard]] double value_at(float y) const;
  [[nodiscard]] double values_per_unit() const { return (high - low) / static_cast<double>(bottom - top); }

  /// factor > 1 shows more; the value under `y` stays where it is.
  void zoom(float y, double factor);
  void pan(double values);
  /// Shows [lowest, highest] with a margin of a tenth; a flat stretch gets `least_height` around it.
  void fit(double lowest, double highest, double least_height);
};

/// Lowest and highest finite value of samples; empty when there is none.
struct ValueRange {
  double low = 0.0;
  double high = 0.0;
  bool empty = true;

  void add(double value);
  void add(std::span<const double> values);
};

}  // namespace marey::app
