#pragma once

#include <vector>

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

/// A figure and its motion. motion.channel_count() == skeleton.channel_count() and the names of the skeleton are read in
/// settings.names_in, always.
struct Clip {
  Skeleton skeleton;
  Motion motion;
  ClipSettings settings;
  /// By frame: which frame of the opened file it was, rising. Empty as long as all of them are there.
  std::vector<FrameIndex> file_frames{};
};

}  // namespace marey
