#include "core/motion/motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace marey {

Motion::Motion(int channel_count, int frame_count, double frame_time_s)
    : Motion(channel_count, frame_count, frame_time_s, std::vector<double>(idx(channel_count) * idx(frame_count))) {}

Motion::Motion(int channel_count, int frame_count, double frame_time_s, std::vector<double> samples)
    : channel_count_(channel_count),
      frame_count_(frame_count),
      frame_time_s_(frame_time_s),
      samples_(std::move(samples)) {
  samples_.resize(idx(channel_count) * idx(frame_count));
}

void Motion::exchange_frames(FrameRange range, Motion& other) {
  Motion taken(channel_count_, range.count, other.frame_time_s_);
  Motion result(channel_count_, frame_count_ - range.count + other.frame_count_, frame_time_s_);
  for (ChannelIndex c = 0; c < channel_count_; ++c) {
    const std::span<const double> before = std::as_const(*this).channel_samples(c);
    const std::span<const double> added = std::as_const(other).channel_samples(c);
    std::copy_n(before.begin() + range.first, range.count, taken.channel_samples(c).begin());
    auto out = std::copy_n(before.begin(), range.first, result.channel_samples(c).begin());
    out = std::copy(added.begin(), added.end(), out);
    std::copy(before.begin() + range.end(), before.end(), out);
  }
  *this = std::move(result);
  other = std::move(taken);
}

double display_frame_rate_hz(double frame_time_s) {
  constexpr double kTolerance = 2e-4;
  const double rate = 1.0 / frame_time_s;
  const double whole = std::round(rate);
  const double ntsc = std::round(rate * 1.001) / 1.001;
  const double nearest = std::abs(rate - ntsc) < std::abs(rate - whole) ? ntsc : whole;
  return std::abs(rate - nearest) <= kTolerance * rate ? nearest : rate;
}

}  // namespace marey
