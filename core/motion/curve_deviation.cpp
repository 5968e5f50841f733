#include "core/motion/curve_deviation.h"

#include <cmath>

namespace marey {

CurveDeviation find_deviation(std::span<const double> samples, std::span<const double> others) {
  CurveDeviation deviation;
  double scale = 0.0;  // the largest difference so far: squares of differences in its unit neither overflow nor vanish
  double squares = 0.0;
  int count = 0;
  for (int i = 0; i < size_of(samples); ++i) {
    const double difference = std::abs(samples[idx(i)] - others[idx(i)]);
    if (!std::isfinite(samples[idx(i)]) || !std::isfinite(others[idx(i)])) continue;
    ++count;
    if (difference > scale) {
      squares = 1.0 + squares * (scale / difference) * (scale / difference);
      scale = difference;
      deviation.at = i;
    } else if (scale > 0.0) {
      squares += (difference / scale) * (difference / scale);
    }
  }
  deviation.largest = scale;
  if (count > 0) deviation.rms = scale * std::sqrt(squares / count);
  return deviation;
}

}  // namespace marey
