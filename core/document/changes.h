#pragma once

#include <cstdint>
#include <string>

#include "core/motion/clip.h"

namespace marey {

/// In what a document differs from the file as it was last opened or saved.
struct Changes {
  int channels = 0;          ///< with samples that differ
  std::int64_t samples = 0;  ///< that differ, in all channels
  FrameRange frames;         ///< from the first to the last frame with such a sample
  int removed_frames = 0;
  int added_frames = 0;
  bool figure = false;       ///< other joints, names or channels; then samples and offsets are not compared
  int offsets = 0;           ///< of joints and end sites
  bool frame_time = false;

  [[nodiscard]] bool empty() const {
    return samples == 0 && !figure && offsets == 0 && removed_frames == 0 && added_frames == 0 && !frame_time;
  }
};

/// For people, frames counted from 1: "3 samples in 2 channels, frames 5 to 9; 1 frame left out; 1 offset; the frame time".
/// "nothing" when nothing differs.
[[nodiscard]] std::string describe(const Changes& changes);

}  // namespace marey
