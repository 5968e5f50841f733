#pragma once

#include <span>
#include <vector>

#include "core/base/index.h"

namespace marey {

/// The median of each `window` neighbouring samples, odd and >= 1; `result` has the curve's length. Near the ends the
/// window is as wide as it can be on both sides, so curves that only rise or only fall stay to the bit, and so do the
/// first and last sample. Samples that are not finite stay and do not count. Costs frames times window at most, in
/// practice little more than the frames.
void compute_median(std::span<const double> curve, int window, std::span<double> result);

/// What counts as a spike.
struct SpikeRule {
  int most_frames = 3;     ///< the longest spike, >= 1
  double times_step = 8.0; ///< its height in usual steps from frame to frame around it and in the whole curve
  double least_height = 0; ///< in the curve's unit; lower ones are left
};

/// Runs of frames that stand out from both of their sides: away from the median of their surroundings by more than the
/// rule allows, and for no longer. Usual steps are medians, so the spikes themselves do not count as usual.
[[nodiscard]] std::vector<FrameRange> find_spikes(std::span<const double> curve, const SpikeRule& rule);

}  // namespace marey
