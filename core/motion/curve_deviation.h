#pragma once

#include <span>

#include "core/base/index.h"

namespace marey {

/// How far two curves are apart, in their unit.
struct CurveDeviation {
  double largest = 0.0;
  FrameIndex at = 0;  ///< position of the first pair with the largest difference
  double rms = 0.0;   ///< root mean square over the pairs that count
};

/// Of `samples` from `others`, which has the same length. Pairs that are not both finite do not count; without any other
/// all is 0.
[[nodiscard]] CurveDeviation find_deviation(std::span<const double> samples, std::span<const double> others);

}  // namespace marey
