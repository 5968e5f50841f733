#pragma once

#include <span>
#include <vector>

#include "core/base/index.h"

namespace marey {

/// The samples of a clip: one double per channel and frame, in degrees or file units as in the file.
/// Channel-major: the samples of one channel over time are contiguous, so a curve is a span.
class Motion {
 public:
  Motion() = default;
  /// All samples 0.
  Motion(int channel_count, int frame_count, double frame_time_s);
  /// Takes `samples` (channel-major, channel_count * frame_count values) over.
  Motion(int channel_count, int frame_count, double frame_time_s, std::vector<double> samples);

  [[nodiscard]] int channel_count() const { return channel_count_; }
  [[nodiscard]] int frame_count() const { return frame_count_; }
  /// Seconds per frame as the file gives it; see core/motion/frame_time.h for the range.
  [[nodiscard]] double frame_time_s() const { return frame_time_s_; }
  void set_frame_time_s(double frame_time_s) { frame_time_s_ = frame_time_s; }
  /// Time of the last frame, in seconds; the first is at 0.
  [[nodiscard]] double duration_s() const { return frame_count_ > 1 ? (frame_count_ - 1) * frame_time_s_ : 0.0; }

  [[nodiscard]] double sample(ChannelIndex channel, FrameIndex frame) const { return channel_samples(channel)[idx(frame)]; }
  [[nodiscard]] std::span<const double> channel_samples(ChannelIndex channel) const {
    return std::span(samples_).subspan(idx(channel) * idx(frame_count_), idx(frame_count_));
  }
  [[nodiscard]] std::span<double> channel_samples(ChannelIndex channel) {
    return std::span(samples_).subspan(idx(channel) * idx(frame_count_), idx(frame_count_));
  }
  /// The motion in which the frames of `range`, which lies within it, have given way to those of `inserted`, which may be
  /// none and has as many channels. The frame time stays.
  [[nodiscard]] Motion with_frames_replaced(FrameRange range, const Motion& inserted) const;
  /// The frames of `range` alone, which lies within the motion.
  [[nodiscard]] Motion frames_of(FrameRange range) const;
  /// All samples, channel after channel.
  [[nodiscard]] std::span<const double> samples() const { return samples_; }

 private:
  int channel_count_ = 0;
  int frame_count_ = 0;
  double frame_time_s_ = 1.0 / 30.0;
  std::vector<double> samples_;
};

/// Frames per second for display: 1/frame time, snapped to the nearest whole number or NTSC rate (n/1.001) when the
/// written frame time is that rate cut to its decimals (".0083333" is 120, "0.033333" is 30). Tolerance 0.02 %.
[[nodiscard]] double display_frame_rate_hz(double frame_time_s);

}  // namespace marey
