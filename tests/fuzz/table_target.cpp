#include "core/bvh/reader.h"
#include "core/table/csv.h"
#include "core/table/csv_reader.h"
#include "tests/fuzz/input_bytes.h"
#include "tests/fuzz/soundness.h"
#include "tests/support/same_bits.h"

namespace marey::test {
namespace {

constexpr std::string_view kFigures[] = {
    "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 10 0\n}\n}\n"
    "MOTION\nFrames: 1\nFrame Time: 0.04\n1 2 3\n",
    "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\nJOINT a\n{\n"
    "OFFSET 0 1 0\nCHANNELS 2 Xrotation Xrotation\nJOINT b,\"c\n{\nOFFSET 1 0 0\nCHANNELS 0\n}\n}\n}\n"
    "MOTION\nFrames: 0\nFrame Time: 0.04\n"};

Harm find_harm_in_channels(std::string_view text, const BvhClip& figure, const TableOptions& options) {
  const Result<BvhClip> clip = read_channel_table(text, figure, options);
  if (!clip) return find_harm_in_refusal(clip.error(), text);
  if (!same_tree(clip->skeleton, figure.skeleton)) return "another figure";
  if (Harm harm = find_harm_in_clip(*clip, text)) return harm;
  if (clip->motion.frame_count() < 2) return std::nullopt;
  std::string table;
  append_channel_header(clip->skeleton, table);
  append_channel_rows(clip->motion, {0, clip->motion.frame_count()}, table);
  const Result<BvhClip> again = read_channel_table(table, figure);
  if (!again) return "a written table is refused: " + again.error().message + "\n" + table;
  return same_numbers(clip->skeleton, clip->motion, again->skeleton, again->motion) ? std::nullopt
                                                                                    : Harm("a written table says something else\n" + table);
}

Harm find_harm_in_points(std::string_view text, const TableOptions& options) {
  const Result<BvhClip> clip = read_points_table(text, options);
  return clip ? find_harm_in_clip(*clip, text) : find_harm_in_refusal(clip.error(), text);
}

}  // namespace

Harm find_harm_in_table(std::string_view input) {
  InputBytes bytes(input);
  const int choice = bytes.take_byte();
  const Result<BvhClip> figure = read_bvh(kFigures[choice & 1]);
  if (!figure) return "the test's own figure is refused";
  TableOptions options;
  options.strict = (choice & 2) != 0;
  if ((choice & 4) != 0) options.limits = {3, 3, 7, 4, 160, 4096};
  if (Harm harm = find_harm_in_channels(bytes.rest(), *figure, options)) return harm;
  return find_harm_in_points(bytes.rest(), options);
}

}  // namespace marey::test
