#pragma once

#include <span>

#include "core/base/result.h"
#include "core/motion/motion.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// The frames of `range`, as far as the motion has them; the same frame time.
[[nodiscard]] Motion trimmed(const Motion& motion, FrameRange range);

/// The same movement at another number of frames per second, from its first frame to the last that still fits.
/// The motion's own rate is display_frame_rate_hz of its frame time, so ".0083333" to 30 Hz takes every fourth frame
/// exactly. Frames that coincide keep their samples bit for bit; at the own rate all do, and so does the frame time.
///
/// Between frames, rotations of joints with two or three different neighbouring axes go by slerp along the short way and
/// back to the angles nearest to those of the nearest frame: turns are kept (363 degrees stays 363), and the curves
/// jump only where they did before. All other channels are linear: positions, hinges, unusual lists of rotations.
///
/// Error InvalidArgument: the rate is no number, its inverse is no is_frame_time(), or it gives more than kMaxResampledSamples samples.
[[nodiscard]] Result<Motion> resampled(const Skeleton& skeleton, const Motion& motion, double new_rate_hz);

/// A place between frames; within a millionth of a frame, that frame: the ratio of two rates is rarely exact.
[[nodiscard]] double snapped_to_frame(double frame);

/// The movement at any times, in the same way: each of `frames` counts in frames of the motion, with fraction, is snapped to
/// frames that are close and clamped to what the motion has, which is one frame at least. The frame time stays.
[[nodiscard]] Motion resampled_at(const Skeleton& skeleton, const Motion& motion, std::span<const double> frames);

/// 1 GiB.
inline constexpr double kMaxResampledSamples = 134'217'728.0;

}  // namespace marey
