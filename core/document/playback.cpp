#include "core/document/playback.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace marey {
namespace {

// A position this close below a whole frame is that frame: sums of ticks are not exact, and without this a frame
// would now and then be shown twice and the next one not at all.
constexpr double kRoundingFrames = 1e-6;
// More than any clip has; bounds what a broken clock or frame time can ask for.
constexpr double kMaxAdvanceFrames = 1e12;

}  // namespace

Playback::Playback(int frame_count, double frame_time_s)
    : frame_count_(std::max(frame_count, 0)), frame_time_s_(frame_time_s), range_{0, frame_count_} {}

FrameIndex Playback::frame() const { return static_cast<FrameIndex>(std::lround(position_)); }

void Playback::set_position(double frame) {
  if (std::isnan(frame)) return;
  position_ = std::clamp(frame, 0.0, static_cast<double>(std::max(frame_count_ - 1, 0)));
  exact_position_ = position_;
}

void Playback::step(int frames) {
  set_playing(false);
  const double from = frames > 0 ? std::floor(position_) : std::ceil(position_);
  set_position(std::clamp(from + frames, static_cast<double>(range_.first), static_cast<double>(last_frame())));
}

void Playback::set_playing(bool playing) {
  if (playing == playing_) return;
  playing_ = playing && range_.count > 1;
  exact_position_ = speed_ >= 1.0 ? frame() : position_;
  const bool starts_over = exact_position_ < range_.first || exact_position_ >= last_frame();
  if (!playing_ || !starts_over) return;
  set_position(range_.first);
}

void Playback::set_speed(double speed) {
  if (!std::isnan(speed)) speed_ = std::clamp(speed, kMinSpeed, kMaxSpeed);
}

void Playback::set_range(FrameRange range) {
  if (frame_count_ == 0) return;
  const std::int64_t end = std::int64_t{range.first} + std::max(range.count, 1);
  range_.first = std::clamp(range.first, 0, frame_count_ - 1);
  range_.count = static_cast<int>(std::clamp<std::int64_t>(end, range_.first + 1, frame_count_)) - range_.first;
  if (range_.count < 2) playing_ = false;
}

void Playback::set_clip(int frame_count, double frame_time_s) {
  frame_time_s_ = frame_time_s;
  if (frame_count == frame_count_) return;
  const bool was_whole = range_ == FrameRange{0, frame_count_};
  frame_count_ = std::max(frame_count, 0);
  set_position(position_);
  if (was_whole || frame_count_ == 0) range_ = {0, frame_count_};
  set_range(range_);
  if (range_.count < 2) playing_ = false;
}

bool Playback::advance(double elapsed_s) {
  if (!playing_ || std::isnan(elapsed_s) || elapsed_s <= 0.0) return playing_;
  const double first = range_.first;
  const double end = range_.end();
  const bool outside = exact_position_ < first - kRoundingFrames || exact_position_ >= end;
  const double frames = std::min(elapsed_s * speed_ / frame_time_s_, kMaxAdvanceFrames);
  exact_position_ = outside ? first : exact_position_ + frames;
  if (loops_) {
    if (exact_position_ + kRoundingFrames >= end) {
      exact_position_ = first + std::fmod(exact_position_ + kRoundingFrames - first, range_.count) - kRoundingFrames;
    }
  } else if (exact_position_ + kRoundingFrames >= last_frame()) {
    exact_position_ = last_frame();
    playing_ = false;
  }
  const double shown = speed_ >= 1.0 ? std::floor(exact_position_ + kRoundingFrames) : exact_position_;
  position_ = std::clamp(shown, first, static_cast<double>(last_frame()));
  return playing_;
}

}  // namespace marey
