#include "cli/table_output.h"

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

ExitCode write_channel_table(const std::string& file, const Skeleton& skeleton, const Motion& motion) {
  std::string header;
  append_channel_header(skeleton, header);
  return write_table(file, std::move(header), motion.frame_count(),
                     [&](FrameRange frames, std::string& out) { append_channel_rows(motion, frames, out); });
}

ExitCode write_position_table(const std::string& file, const BvhClip& clip) {
  std::string header;
  append_position_header(clip.skeleton, header);
  const auto append_rows = [&](FrameRange frames, std::string& out) {
    append_position_rows(clip.skeleton, clip.motion, frames, clip.position_rule, out);
  };
  return write_table(file, std::move(header), clip.motion.frame_count(), append_rows);
}

}  // namespace marey::cli
