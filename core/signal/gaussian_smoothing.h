#pragma once

#include <span>

#include "core/base/index.h"

namespace marey {

/// Smooths the frames `run` of a curve into `smoothed` (run.count values) with a Gaussian of standard deviation
/// `sigma_frames`, > 0 and finite, at most the length of the curve; the kernel is cut at 4 sigma and normalised. The
/// curve is continued beyond its first and last finite sample by point reflection about it. A sample that is not finite
/// stays and weighs nothing in the others, nor does the sample opposite of it: constants and straight lines stay exact.
void compute_gaussian_smoothed(std::span<const double> curve, FrameRange run, double sigma_frames,
                               std::span<double> smoothed);

}  // namespace marey
