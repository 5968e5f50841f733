#pragma once

#include "core/base/index.h"

namespace marey {

/// Where the clip is being looked at. Time is handed in by the caller; there is no clock here.
class Playback {
 public:
  Playback() = default;
  Playback(int frame_count, double frame_time_s);

  /// Position in frames, 0-based; between whole numbers while playing slowly or scrubbing freely.
  [[nodiscard]] double position() const { return position_; }
  /// Nearest whole frame.
  [[nodiscard]] FrameIndex frame() const;
  [[nodiscard]] bool is_playing() const { return playing_; }
  [[nodiscard]] bool loops() const { return loops_; }
  /// 1: the clip's own rate; > 0; at most 16.
  [[nodiscard]] double speed() const { return speed_; }
  /// Frames that playing stays within, at least one.
  [[nodiscard]] FrameRange range() const { return range_; }

  void set_position(double frame);  ///< clamped to the clip
  void step(int frames);            ///< pauses and moves by whole frames, clamped to the range
  void set_playing(bool playing);   ///< starting at the end of the range starts over
  void set_loops(bool loops) { loops_ = loops; }
  void set_speed(double speed);
  void set_range(FrameRange range);  ///< clamped to the clip
  void set_frame_time_s(double frame_time_s) { frame_time_s_ = frame_time_s; }

  /// Moves on by `elapsed_s` of wall time; wraps round in a loop, stops at the end of the range otherwise. At normal
  /// speed and above the position is a whole frame (the clip's own frames are shown); below, poses are interpolated.
  /// Returns true while playing.
  bool advance(double elapsed_s);

 private:
  int frame_count_ = 0;
  double frame_time_s_ = 1.0 / 30.0;
  double exact_position_ = 0.0;
  double position_ = 0.0;
  double speed_ = 1.0;
  bool playing_ = false;
  bool loops_ = true;
  FrameRange range_;
};

}  // namespace marey
