#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/bvh/row_text.h"
#include "core/bvh/style.h"

namespace marey {

/// How frames lie in the lines of a file.
enum class RowLayout : std::uint8_t {
  LinePerFrame,  ///< a line is a frame; one that is cut short is seen as such, unless it goes on in the next line
  CutLines,      ///< a line is a frame, and nearly all lines have the same wrong number of values
  Stream,        ///< line ends mean nothing; every channel_count values make a frame
};

/// What the first rows tell about all of them.
struct MotionSurvey {
  RowLayout layout = RowLayout::LinePerFrame;
  NumberLook look;
  int values_per_line = 0;  ///< of the usual line
  double bytes_per_row = 0.0;
  std::vector<ColumnStyle> columns;  ///< one per channel
};

/// Looks at the first rows of `rows`, which begins with the first sample.
[[nodiscard]] MotionSurvey survey_rows(std::string_view rows, int channel_count,
                                       std::optional<std::int64_t> declared_frames, std::string_view line_end);

}  // namespace marey
