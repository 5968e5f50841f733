#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/bvh/limits.h"
#include "core/bvh/report.h"
#include "core/bvh/row_text.h"
#include "core/bvh/style.h"

namespace marey {

/// A part of a file's text.
struct TextPart {
  std::string_view text;
  std::size_t begin = 0;  ///< of text[0] in the file
};

/// What the rows are read with. Places count in the file.
struct RowsInput {
  TextPart part;                ///< with the first sample, and without NUL bytes at the end of the file
  std::size_t data_begin = 0;   ///< the first sample
  std::int64_t rows_bytes = 0;  ///< from there to the end of the file, or what is known of it
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

/// Notes that `look` gives commas a meaning; `rows` hold one then.
void report_commas(TextPart rows, const NumberLook& look, Report& report);

/// Reads frames until the text ends or says something else. What `Frames:` promises is compared, not trusted.
[[nodiscard]] MotionRows read_motion_rows(const RowsInput& input, const ReadLimits& limits, Report& report);

}  // namespace marey
