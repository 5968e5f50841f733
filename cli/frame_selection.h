#pragma once

#include <optional>
#include <string_view>

namespace marey::cli {

/// Frames as people name them: "5:8" is the fifth to the eighth, both included.
struct FrameSelection {
  int first = 1;  ///< from 1
  int last = 1;   ///< >= first
};

/// Nothing when the text is not FIRST:LAST.
[[nodiscard]] std::optional<FrameSelection> parse_frame_selection(std::string_view text);

}  // namespace marey::cli
