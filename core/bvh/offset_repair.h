#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/bvh/joint_lines.h"

namespace marey {

/// One reading of an OFFSET that does not have three values.
struct OffsetReading {
  glm::dvec3 offset{0.0};
  std::string text;  ///< "0.0 10.0 0.0"
};

/// All sensible readings, the best first; never empty. Too many values: a lost decimal point ("0 0 10.0 0.0" is
/// "0.0 10.0 0.0"), else a surplus zero, else the first three. Too few: zeros are added.
[[nodiscard]] std::vector<OffsetReading> find_offset_readings(std::string_view text, const OffsetRead& offset);

/// Says which reading of an OFFSET was taken. `owner` is "'Body'" or "the end site".
void report_offset_reading(std::string_view owner, std::size_t place, int value_count, const OffsetReading& reading,
                           Report& report);

/// The edit that makes the text of an OFFSET say `reading`. `keyword_end` is behind the word OFFSET.
void patch_offset(const OffsetRead& offset, std::size_t keyword_end, const OffsetReading& reading, HeaderPatches& patches);

}  // namespace marey
