#pragma once

#include <vector>

#include "core/motion/body_choice.h"
#include "core/motion/layers.h"
#include "core/motion/motion.h"
#include "core/skeleton/channel.h"
#include "core/skeleton/position_rule.h"
#include "core/skeleton/skeleton.h"
#include "core/text/character_set.h"

namespace marey {

/// What a BVH file leaves open and Marey guesses, shows and lets people change.
struct ClipSettings {
  PositionRule position_rule = PositionRule::Replace;
  Axis up_axis = Axis::Y;
  double metres_per_unit = 0.01;  ///< > 0
  CharacterSet names_in = CharacterSet::Utf8;  ///< of the bytes of the names
  friend bool operator==(const ClipSettings&, const ClipSettings&) = default;
};

/// In Clip::file_frames: a frame that was made by an edit.
inline constexpr FrameIndex kNewFrame = -1;

/// A figure and its motion. motion.channel_count() == skeleton.channel_count() and the names of the skeleton are read in
/// settings.names_in, always.
struct Clip {
  Skeleton skeleton;
  Motion motion;
  ClipSettings settings;
  /// By frame: which frame of the opened file it was, rising; kNewFrame for one that the file does not have. Empty as long
  /// as all of the file's are there and no other.
  std::vector<FrameIndex> file_frames{};
  /// What the samples are made of where they are more than samples: `motion` always holds the result, and for each channel
  /// of layered_channels() the stack holds what is beneath.
  LayerStack stack{};
  BodyChoice body{};
};

}  // namespace marey
