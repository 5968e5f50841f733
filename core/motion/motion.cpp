#include "core/motion/motion.h"

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

double display_frame_rate_hz(double frame_time_s) {
  constexpr double kTolerance = 2e-4;
  const double rate = 1.0 / frame_time_s;
  const double whole = std::round(rate);
  const double ntsc = std::round(rate * 1.001) / 1.001;
  const double nearest = std::abs(rate - ntsc) < std::abs(rate - whole) ? ntsc : whole;
  return std::abs(rate - nearest) <= kTolerance * rate ? nearest : rate;
}

}  // namespace marey
