#include "tests/core/table/tables.h"

#include "core/table/csv.h"

namespace marey::test {

std::string channel_table(const BvhClip& clip, const std::string& length_unit) {
  std::string text;
  append_channel_header(clip.skeleton, text, length_unit);
  append_channel_rows(clip.motion, {0, clip.motion.frame_count()}, text);
  return text;
}

std::string position_table(const BvhClip& clip, const std::string& length_unit) {
  std::string text;
  append_position_header(clip.skeleton, text, length_unit);
  append_position_rows(clip.skeleton, clip.motion, {0, clip.motion.frame_count()}, clip.position_rule, text);
  return text;
}

}  // namespace marey::test
