#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/motion/motion.h"
#include "core/skeleton/skeleton.h"

namespace marey::cli {

/// The range that the samples of a channel keep to, in degrees or file units; a missing side is infinite.
struct ChannelLimit {
  std::string channel;  ///< as channel_label() calls it: "Legs Zrotation"
  double min;
  double max;
};

/// Reads {"limits": [{"channel": "Legs Zrotation", "min": -40, "max": 5}, ...]}; min or max may be left out. Anything
/// else in the text is refused, so that a misspelt key does not switch a limit off.
[[nodiscard]] Result<std::vector<ChannelLimit>> read_limits(std::string_view json_text);

/// A run of frames in which a channel is on one side outside of its limit.
struct Violation {
  ChannelIndex channel = 0;
  FrameRange frames;
  bool is_above = false;
  double limit = 0.0;
  double worst = 0.0;  ///< the sample farthest outside, the first not-a-number if there is one
  FrameIndex worst_frame = 0;
};

/// In the order of `limits`, then channels, then frames. A name that no channel has is an error.
[[nodiscard]] Result<std::vector<Violation>> find_violations(const Skeleton& skeleton, const Motion& motion,
                                                             const std::vector<ChannelLimit>& limits);

/// "Legs Zrotation is above 5 in frames 11-14, at worst 12.3 in frame 13"
[[nodiscard]] std::string violation_sentence(const Skeleton& skeleton, const Violation& violation);

}  // namespace marey::cli
