#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/base/text_cursor.h"
#include "core/bvh/header_patch.h"
#include "core/bvh/report.h"
#include "core/bvh/style.h"

namespace marey {

/// What stands between the hierarchy and the first sample.
struct MotionHeader {
  std::optional<std::int64_t> declared_frames;  ///< as written, not checked against the rows; >= 0
  double frame_time_s = 1.0 / 30.0;             ///< to use: > 0 and finite
  NumberSlot frame_count_slot;
  NumberSlot frame_time_slot{0, 0, 1.0 / 30.0};  ///< its value is frame_time_s, whatever the text says
  std::size_t data_begin = 0;   ///< the first sample, or the end of the text
  HeaderPatches patches;        ///< where a part is missing or means nothing
};

/// Reads MOTION, Frames: and Frame Time: in any order and spacing; each may be missing. A line of `channel_count` words,
/// some of them numbers, is the first row even if it begins with a word.
[[nodiscard]] MotionHeader read_motion_header(TextCursor& cursor, int channel_count, Report& report);

/// True for what can begin a sample: a digit, sign or point, or a spelling of "not a number".
[[nodiscard]] bool starts_like_number(std::string_view word);

}  // namespace marey
