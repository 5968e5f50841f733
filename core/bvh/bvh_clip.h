#pragma once

#include "core/base/diagnostic.h"
#include "core/bvh/style.h"
#include "core/motion/motion.h"
#include "core/skeleton/position_rule.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// What a BVH file says: the figure, its motion, how the text was written, and what was noticed while reading.
/// motion.channel_count() == skeleton.channel_count(), always.
struct BvhClip {
  Skeleton skeleton;
  Motion motion;
  BvhStyle style;
  Diagnostics diagnostics;  ///< they quote bytes of the file; for people see core/text/readable.h
  /// The rule that the file's numbers speak for; a diagnostic says so where it matters.
  PositionRule position_rule = PositionRule::Replace;
  /// What "Frames:" says, where the file holds more frames and all of them were read; 0 otherwise.
  int declared_frames = 0;
  /// What the bytes of the names speak for, and what they were read in; a diagnostic says so if it is not UTF-8.
  CharacterSet names_in = CharacterSet::Utf8;
};

}  // namespace marey
