#pragma once

#include <span>
#include <vector>

#include "core/motion/clip.h"

namespace marey::lint {

/// Clips with fewer frames have no habits to compare with, and clips with longer frame times are lists of poses.
inline constexpr int kLeastFrames = 8;
inline constexpr double kLongestFrameTime_s = 0.1;

/// True if the frames follow each other closely enough for steps between them to mean something.
[[nodiscard]] bool is_recording(const Motion& motion);

/// Frames that make up `duration_s`, at least `least`.
[[nodiscard]] int frames_in(const Motion& motion, double duration_s, int least);

/// Angle by which the rotation of a joint differs between two frames: degrees in [0, 180], whatever its Euler angles
/// do. 180 where an angle is not finite.
[[nodiscard]] double turn_between_deg(const Clip& clip, JointIndex joint, FrameIndex a, FrameIndex b);

/// The steps of one channel from frame to frame; the buffers serve one channel after the other.
class CurveSteps {
 public:
  /// Steps within `frames`; whole turns are taken from those of a rotation.
  void load(const Clip& clip, ChannelIndex channel, FrameRange frames);

  /// values()[i] is the step from frame frames.first + i to the next, 0 where a sample is not finite.
  [[nodiscard]] std::span<const double> values() const { return steps_; }

  /// Median of the absolute second differences: how much the steps of this channel usually change.
  [[nodiscard]] double compute_usual_change();

  /// Median of the absolute steps around step i, up to kNeighbours on each side, without steps i to i + count - 1.
  [[nodiscard]] double compute_neighbour_step(int i, int count);

  static constexpr int kNeighbours = 4;

 private:
  std::vector<double> steps_;
  std::vector<double> scratch_;
};

}  // namespace marey::lint
