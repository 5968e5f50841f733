#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/clip.h"

namespace marey {

/// New samples for the frames [first, first + values.size()) of one channel.
struct SamplesChange {
  ChannelIndex channel = 0;
  FrameIndex first = 0;
  std::vector<double> values;
};

/// New OFFSET of a joint or end site, file units.
struct OffsetChange {
  NodeIndex node = 0;
  glm::dvec3 offset{0.0};
};

/// A change of a clip as a value: a name for the Edit menu ("Smooth 3 channels") and the new content of what it
/// touches, nothing else, so that the history stores deltas. Changes of one edit do not overlap.
struct Edit {
  std::string name;
  std::vector<SamplesChange> samples;
  std::vector<OffsetChange> offsets;
  std::optional<ClipSettings> settings;
  std::optional<double> frame_time_s;

  [[nodiscard]] bool empty() const { return samples.empty() && offsets.empty() && !settings && !frame_time_s; }
};

/// Exchanges the content of `edit` with that of the clip: the clip gets the new values and the edit holds the old ones,
/// so the same call undoes and redoes. Every index in the edit is valid for the clip.
void swap_edit(Clip& clip, Edit& edit);

/// Bytes that an edit keeps, for the history's bound.
[[nodiscard]] std::size_t edit_bytes(const Edit& edit);

/// Frames whose poses an edit changes: the hull of its samples, the whole clip if it moves an offset or the rule.
[[nodiscard]] FrameRange edited_frames(const Clip& clip, const Edit& edit);

}  // namespace marey
