#pragma once

#include <array>
#include <cstddef>

#include "wasm/platform/backend.h"

namespace marey::app {

/// What one frame took, measured by who drew it.
struct FrameCost {
  double cpu_ms = 0.0;  ///< of the processor; the graphics card is not waited for
  int draw_calls = 0;
  int vertices = 0;
};

/// What the last frames took, for the performance card. Allocates nothing.
class Performance {
 public:
  static constexpr int kFramesKept = 120;

  /// `now_s`: when the frame began; `playing`: whether it showed a clip that plays.
  void add_frame(const FrameCost& cost, double now_s, bool playing);

  [[nodiscard]] int frame_count() const { return count_; }
  /// Milliseconds of a frame; 0 is the oldest that is kept.
  [[nodiscard]] float cpu_ms(int index) const {
    return cpu_ms_[static_cast<std::size_t>((next_ + kFramesKept - count_ + index) % kFramesKept)];
  }
  [[nodiscard]] const FrameCost& last() const { return last_; }
  /// Of the kept frames; 0 while there are none.
  [[nodiscard]] float median_ms() const;
  [[nodiscard]] float worst_ms() const;
  /// While the clip plays or last played, over half a second at a time; 0 before.
  [[nodiscard]] double frames_per_second() const { return frames_per_second_; }

  Backend::Memory memory;           ///< when last measured; 0 where it is not known
  double memory_measured_s = -1.0;  ///< measuring walks the heap: not in each frame

 private:
  void count_playing(double now_s, bool playing);

  std::array<float, kFramesKept> cpu_ms_{};
  int count_ = 0;
  int next_ = 0;
  FrameCost last_;
  double playing_since_s_ = -1.0;  // of the present half second; negative while nothing plays
  int played_ = 0;
  double frames_per_second_ = 0.0;
};

}  // namespace marey::app
