#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/bvh/limits.h"
#include "core/bvh/report.h"
#include "core/bvh/style.h"

namespace marey {

/// What the rows are read with.
struct RowsInput {
  std::string_view text;        ///< of the whole file, without NUL bytes at its end
  std::size_t data_begin = 0;   ///< the first sample
  int channel_count = 0;        ///< > 0
  std::optional<std::int64_t> declared_frames;
  std::size_t declared_place = 0;
  std::string_view line_end = "\n";
  std::int64_t text_bytes = 0;  ///< memory that the text takes, its conversion included
};

struct MotionRows {
  std::vector<double> samples;  ///< channel-major; all finite
  int frame_count = 0;
  MotionStyle style;            ///< but for the tail
  std::size_t end = 0;          ///< behind the last sample
  bool lines_are_new = false;   ///< every frame gets a line of its own, whatever lines the file had
};

/// Reads frames until the text ends or says something else. What `Frames:` promises is compared, not trusted.
[[nodiscard]] MotionRows read_motion_rows(const RowsInput& input, const ReadLimits& limits, Report& report);

}  // namespace marey
