#pragma once

#include <vector>

#include "core/editing/edit.h"
#include "core/editing/sample_selection.h"
#include "core/motion/clip.h"
#include "tests/support/random.h"
#include "tests/support/same_bits.h"

namespace marey::test {

/// "Hips" with Xposition Yposition Zposition Zrotation Xrotation Yrotation, then a chain "Joint1", "Joint2" ... with
/// Zrotation Xrotation Yrotation each and an end site. All samples 0, 30 frames a second.
[[nodiscard]] Clip make_clip(int joint_count, int frame_count);

/// make_clip(1, curve.size()) whose channel 3, "Hips Zrotation", has these samples.
[[nodiscard]] Clip make_clip_with_curve(const std::vector<double>& curve);
inline constexpr ChannelIndex kCurve = 3;

/// Any tree of up to 6 joints and any channels, 0 to 40 frames; now and then a sample that is NaN, infinite or -0.
[[nodiscard]] Clip make_random_clip(Random& random);

/// Runs anywhere, also some that reach beyond the clip.
[[nodiscard]] SampleSelection make_random_selection(Random& random, const Clip& clip);

/// Any edit there is, with any numbers; some are empty, some change nothing, some are to be refused.
[[nodiscard]] Edit make_random_edit(Random& random, const Clip& clip);

/// Samples of a curve as a vector that a matcher can print.
[[nodiscard]] std::vector<double> samples_of(const Clip& clip, ChannelIndex channel);

/// The clip after an edit, which must fit.
[[nodiscard]] Clip edited(Clip clip, Edit edit);

[[nodiscard]] SampleSelection selected(ChannelIndex channel, FrameRange frames);

}  // namespace marey::test
