#include "core/signal/range_statistics.h"

#include <algorithm>
#include <cmath>

namespace marey {

std::optional<RangeStatistics> find_range_statistics(std::span<const double> curve, FrameRange frames) {
  RangeStatistics found;
  for (FrameIndex frame = frames.first; frame < frames.end(); ++frame) {
    const double value = curve[idx(frame)];
    if (!std::isfinite(value)) continue;
    if (found.count == 0 || value < found.least) {
      found.least = value;
      found.least_frame = frame;
    }
    if (found.count == 0 || value > found.greatest) {
      found.greatest = value;
      found.greatest_frame = frame;
    }
    ++found.count;
    found.mean += (value - found.mean) / found.count;
  }
  if (found.count == 0) return std::nullopt;
  // Squares of large values would overflow.
  const double scale = std::max(std::abs(found.least), std::abs(found.greatest));
  if (!(scale > 0.0)) return found;
  double squares = 0.0;
  for (FrameIndex frame = frames.first; frame < frames.end(); ++frame) {
    const double share = curve[idx(frame)] / scale;
    if (std::isfinite(share)) squares += share * share;
  }
  found.rms = scale * std::sqrt(squares / found.count);
  return found;
}

}  // namespace marey
