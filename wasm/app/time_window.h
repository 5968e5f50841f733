#pragma once

namespace marey::app {

/// The stretch of frames that ruler and curves show, and where it lies on screen. Frames are 0-based and continuous;
/// the shown stretch may reach a little beyond the clip.
struct TimeWindow {
  double first = 0.0;  ///< frame at the left edge
  double last = 1.0;   ///< frame at the right edge; > first
  float left = 0.0f;   ///< screen x of the edges in ImGui units, set by whoever draws first in a frame
  float right = 1.0f;

  bool operator==(const TimeWindow&) const = default;

  [[nodiscard]] double frames_per_unit() const { return (last - first) / static_cast<double>(right - left); }
  [[nodiscard]] float x_of(double frame) const;
  [[nodiscard]] double frame_at(float x) const;

  /// Shows the whole clip with a small margin.
  void fit(int frame_count);
  /// Shows [first_frame, last_frame] with a small margin.
  void fit_range(double first_frame, double last_frame);
  /// factor > 1 shows more; the frame under `x` stays where it is.
  void zoom(float x, double factor, int frame_count);
  void pan(double frames, int frame_count);
};

}  // namespace marey::app
