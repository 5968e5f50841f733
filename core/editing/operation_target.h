#pragma once

#include <vector>

#include "core/motion/clip.h"

namespace marey {

/// What an operation works on. Indices and frames beyond the clip do not count.
struct OperationTarget {
  std::vector<ChannelIndex> channels;  ///< rising
  std::vector<JointIndex> joints;      ///< rising; for operations on joints: those that were named, or that own the channels
  FrameRange frames;
  int blend_in_frames = 0;   ///< over so many frames at the start of the range the operation gains its weight
  int blend_out_frames = 0;  ///< and over so many at its end it loses it
  double weight = 1.0;       ///< of the result beside what was there, 0 to 1
};

/// All channels, joints and frames.
[[nodiscard]] OperationTarget whole_clip(const Clip& clip);

/// Some channels, the joints that own them, and a range.
[[nodiscard]] OperationTarget target_of(const Clip& clip, std::vector<ChannelIndex> channels, FrameRange frames);

/// The part of a target that the clip has.
[[nodiscard]] OperationTarget within_clip(const Clip& clip, OperationTarget target);

/// The weight of each frame of the range: a raised cosine over the frames of the blends, `weight` between them. The frame
/// before the range would have 0, the one behind a blend-in has the full weight.
[[nodiscard]] std::vector<double> blend_weights(const OperationTarget& target);

}  // namespace marey
