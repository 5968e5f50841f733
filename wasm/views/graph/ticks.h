#pragma once

#include <string>

namespace marey::app {

/// Evenly spaced round numbers along an axis: first, first + step ... The step is 1, 2 or 5 times a power of ten.
struct Ticks {
  double first = 0.0;
  double step = 1.0;
  int count = 0;
  int decimals = 0;  ///< that tell neighbours apart

  [[nodiscard]] double at(int index) const { return first + step * index; }
};

/// Ticks within [low, high] that stand at least `least_step` apart. `whole` asks for whole numbers.
[[nodiscard]] Ticks make_ticks(double low, double high, double least_step, bool whole = false);

/// Fixed decimals, a true minus sign left out of zero: "-0.0" is "0.0".
[[nodiscard]] std::string tick_label(double value, int decimals);

}  // namespace marey::app
