#include "wasm/app/performance.h"

#include <algorithm>

namespace marey::app {
namespace {
constexpr double kCountedFor_s = 0.5;
}

void Performance::add_frame(const FrameCost& cost, double now_s, bool playing) {
  last_ = cost;
  cpu_ms_[static_cast<std::size_t>(next_)] = static_cast<float>(cost.cpu_ms);
  next_ = (next_ + 1) % kFramesKept;
  count_ = std::min(count_ + 1, kFramesKept);
  count_playing(now_s, playing);
}

void Performance::count_playing(double now_s, bool playing) {
  if (!playing) {
    playing_since_s_ = -1.0;
    return;
  }
  if (playing_since_s_ < 0.0) {
    playing_since_s_ = now_s;
    played_ = 0;
    return;
  }
  ++played_;
  const double elapsed_s = now_s - playing_since_s_;
  if (elapsed_s < kCountedFor_s) return;
  frames_per_second_ = played_ / elapsed_s;
  playing_since_s_ = now_s;
  played_ = 0;
}

float Performance::median_ms() const {
  if (count_ == 0) return 0.0f;
  std::array<float, kFramesKept> sorted = cpu_ms_;  // the first `count_` are all there are until it is full
  const auto middle = sorted.begin() + count_ / 2;
  std::nth_element(sorted.begin(), middle, sorted.begin() + count_);
  return *middle;
}

float Performance::worst_ms() const { return *std::max_element(cpu_ms_.begin(), cpu_ms_.end()); }

}  // namespace marey::app
