#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/index.h"

namespace marey {

/// How samples between others are made up.
enum class GapFill : std::uint8_t {
  Linear,  ///< a straight line between the two neighbours
  Cubic,   ///< the polynomial through two samples on either side; through fewer where there are no more
};

/// The runs of samples that are not finite. With `still_frames` > 0 also those that repeat the sample before them to the bit,
/// that many times or more: what a recording leaves where it lost sight.
[[nodiscard]] std::vector<FrameRange> find_gaps(std::span<const double> curve, int still_frames = 0);

/// Gives the samples of `gaps` new values; `gaps` rise and lie apart. A gap at an end of the curve takes the value of its
/// only neighbour. Neighbours that are not finite do not count; without any the gap stays.
void fill_gaps(std::span<double> curve, std::span<const FrameRange> gaps, GapFill fill);

}  // namespace marey
