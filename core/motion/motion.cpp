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

Motion Motion::with_frames_replaced(FrameRange range, const Motion& inserted) const {
  Motion result(channel_count_, frame_count_ - range.count + inserted.frame_count_, frame_time_s_);
  for (ChannelIndex c = 0; c < channel_count_; ++c) {
    const std::span<const double> before = channel_samples(c);
    auto out = std::copy_n(before.begin(), range.first, result.channel_samples(c).begin());
    if (inserted.frame_count_ > 0) {
      const std::span<const double> added = inserted.channel_samples(c);
      out = std::copy(added.begin(), added.end(), out);
    }
    std::copy(before.begin() + range.end(), before.end(), out);
  }
  return result;
}

Motion Motion::frames_of(FrameRange range) const {
  Motion result(channel_count_, range.count, frame_time_s_);
  for (ChannelIndex c = 0; c < channel_count_; ++c) {
    std::copy_n(channel_samples(c).begin() + range.first, range.count, result.channel_samples(c).begin());
  }
  return result;
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
