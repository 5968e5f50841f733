#pragma once

#include "core/base/index.h"

namespace marey {

/// Where the clip is being looked at. Time is handed in by the caller; there is no clock here.
class Playback {
 public:
  static constexpr double kMinSpeed = 0.01;
  static constexpr double kMaxSpeed = 16.0;

  Playback() = default;
  Playback(int frame_count, double frame_time_s);

  /// Position in frames, 0-based, never beyond the last frame; between whole numbers while playing slowly or
  /// scrubbing freely.
  [[nodiscard]] int frame_count() const { return frame_count_; }
  [[nodiscard]] double position() const { return position_; }
  /// Nearest whole frame.
  [[nodiscard]] FrameIndex frame() const;
  [[nodiscard]] bool is_playing() const { return playing_; }
  [[nodiscard]] bool loops() const { return loops_; }
  /// 1: the clip's own rate.
  [[nodiscard]] double speed() const { return speed_; }
  /// Frames that playing stays within, at least one; none in a clip without frames.
  [[nodiscard]] FrameRange range() const { return range_; }

  void set_position(double frame);  ///< clamped to the clip
  void step(int frames);            ///< pauses and moves by whole frames, clamped to the range
  /// Starting at the end of the range, or outside of it, starts over. A range of one frame cannot be played.
  void set_playing(bool playing);
  void set_loops(bool loops) { loops_ = loops; }
  void set_speed(double speed);      ///< clamped to kMinSpeed ... kMaxSpeed
  void set_range(FrameRange range);  ///< clamped to the clip
  /// Follows a change of the clip: position and range are kept as far as the clip still has them, a range that was
  /// the whole clip stays the whole clip. `frame_time_s` > 0.
  void set_clip(int frame_count, double frame_time_s);

  /// Moves on by `elapsed_s` of wall time. In a loop each frame of the range lasts one frame time, then the first
  /// follows; otherwise playing stops on reaching the last. At normal speed and above the position is a whole frame
  /// (the clip's own frames are shown); below, poses are interpolated, and a loop holds the last frame for its time.
  /// From outside of the range it goes to the range's first frame. Returns true while playing.
  bool advance(double elapsed_s);

 private:
  [[nodiscard]] FrameIndex last_frame() const { return range_.count > 0 ? range_.end() - 1 : range_.first; }

  int frame_count_ = 0;
  double frame_time_s_ = 1.0 / 30.0;
  double exact_position_ = 0.0;  // while playing: with the fraction of a frame that is not shown yet
  double position_ = 0.0;
  double speed_ = 1.0;
  bool playing_ = false;
  bool loops_ = true;
  FrameRange range_;
};

}  // namespace marey
