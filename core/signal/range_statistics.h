#pragma once

#include <optional>
#include <span>

#include "core/base/index.h"

namespace marey {

/// What a curve does over some frames. Units are those of the curve.
struct RangeStatistics {
  double least = 0.0;
  double greatest = 0.0;
  FrameIndex least_frame = 0;     ///< the first with that value
  FrameIndex greatest_frame = 0;
  double mean = 0.0;
  double rms = 0.0;  ///< root of the mean square, about zero
  int count = 0;     ///< of the samples that are finite; no others count
};

/// `frames` lies within the curve. Nothing where no sample is finite.
[[nodiscard]] std::optional<RangeStatistics> find_range_statistics(std::span<const double> curve, FrameRange frames);

}  // namespace marey
