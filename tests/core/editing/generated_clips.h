#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "core/editing/edit.h"
#include "core/editing/sample_selection.h"
#include "core/motion/clip.h"

namespace marey::test {

/// The same numbers on every host, which the distributions of the standard library do not promise.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// 0 <= result < bound; 0 for bound <= 0.
  int below(int bound) { return bound <= 0 ? 0 : static_cast<int>(engine_() % static_cast<std::uint64_t>(bound)); }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1.0p-53;
  }
  bool one_in(int n) { return below(n) == 0; }

 private:
  std::mt19937_64 engine_;
};

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

/// Everything that an edit can change, bit by bit.
[[nodiscard]] std::vector<std::uint64_t> bits_of(const Clip& clip);

/// Samples of a curve as a vector that a matcher can print.
[[nodiscard]] std::vector<double> samples_of(const Clip& clip, ChannelIndex channel);

/// The clip after an edit, which must fit.
[[nodiscard]] Clip edited(Clip clip, Edit edit);

[[nodiscard]] SampleSelection selected(ChannelIndex channel, FrameRange frames);

}  // namespace marey::test
