#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/index.h"

namespace marey {

/// A curve without ends: continued beyond its first and last finite sample by point reflection about it, again and
/// again, so that straight lines stay straight. A curve without a finite sample has none anywhere.
class ContinuedCurve {
 public:
  explicit ContinuedCurve(std::span<const double> curve);

  [[nodiscard]] double operator[](std::int64_t frame) const;

 private:
  [[nodiscard]] double at(std::int64_t frame) const { return curve_[static_cast<std::size_t>(frame)]; }

  std::span<const double> curve_;
  std::int64_t first_ = 0;
  std::int64_t last_ = 0;
};

/// The frames from the first to the last finite sample; empty when there is none.
[[nodiscard]] FrameRange find_finite_frames(std::span<const double> curve);

/// The frames of `range`, which begin and end with a finite sample, with a straight line through each run of samples that
/// are not finite.
[[nodiscard]] std::vector<double> bridged(std::span<const double> curve, FrameRange range);

/// Gives back to `result` what is not finite in `curve`; both have the same length.
void keep_missing(std::span<const double> curve, std::span<double> result);

}  // namespace marey
