#include "cli/table_output.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/files.h"
#include "core/table/csv.h"

namespace marey::cli {
namespace {

/// Writes a header and all rows, a block of frames at a time, so that memory does not grow with the clip.
template <class AppendRows>
ExitCode write_table(const std::string& file, std::string header, int frame_count, AppendRows append_rows) {
  constexpr int kFramesPerBlock = 256;
  OutputFile output(file);
  output.write(header);
  std::string block;
  for (FrameIndex first = 0; first < frame_count && output.wants_more(); first += kFramesPerBlock) {
    block.clear();
    append_rows(FrameRange{first, std::min(kFramesPerBlock, frame_count - first)}, block);
    output.write(block);
  }
  return output.close() ? ExitCode::Done : ExitCode::BadInput;
}

}  // namespace

ExitCode write_channel_table(const std::string& file, const BvhClip& clip, const std::string& length_unit) {
  std::string header;
  append_channel_header(clip.skeleton, header, length_unit);
  return write_table(file, std::move(header), clip.motion.frame_count(),
                     [&](FrameRange frames, std::string& out) { append_channel_rows(clip.motion, frames, out); });
}

ExitCode write_position_table(const std::string& file, const BvhClip& clip, const std::string& length_unit) {
  std::string header;
  append_position_header(clip.skeleton, header, length_unit);
  const auto append_rows = [&](FrameRange frames, std::string& out) {
    append_position_rows(clip.skeleton, clip.motion, frames, clip.position_rule, out);
  };
  return write_table(file, std::move(header), clip.motion.frame_count(), append_rows);
}

ExitCode write_analysis_table(const std::string& file, const AnalysisTable& table, double frame_time_s, int frame_count) {
  std::vector<NumberColumn> columns;
  for (const AnalysisColumn& column : table.columns) columns.push_back({column.name, column.values});
  std::string header;
  append_columns_header(columns, header);
  return write_table(file, std::move(header), frame_count,
                     [&](FrameRange frames, std::string& out) { append_columns(columns, frame_time_s, frames, out); });
}

void add_units(CLI::App& command, std::string& length_unit) {
  command.add_option("--units", length_unit, "Write units into the header of a table, lengths in this one, which BVH does not tell")
      ->check(CLI::IsMember({"m", "cm", "mm", "in", "ft", "unit"}));
}

}  // namespace marey::cli
