// How much memory reading takes for each byte of a file, where the bytes are chosen to take as much as they can.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/bvh/reader.h"
#include "core/table/csv_reader.h"
#include "tests/core/bvh/bvh_texts.h"
#include "tests/damage/heap_peak.h"
#include "tests/damage/verdict.h"

namespace marey::test {
namespace {

std::string repeated(std::string_view text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

std::string figure(const std::string& lines) { return "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\n" + lines + "}\n"; }

struct Greedy {
  std::string name;
  std::string text;
};

/// 0.1 to 1 MB each, within the limits.
std::vector<Greedy> greedy_texts() {
  const std::string letters = figure("CHANNELS 90000" + repeated(" c", 90'000) + "\n");
  const std::string motion = "MOTION\nFrames: 1\nFrame Time: 1\n";
  return {
      {"joints", figure("CHANNELS 0" + repeated(" JOINT b{}", 9'000))},
      {"joints_without_blocks", figure("CHANNELS 0\n" + repeated("JOINT\n", 9'000))},
      {"end_sites", figure("CHANNELS 0 " + repeated("End Site{}", 9'000))},
      {"blocks", figure("CHANNELS 0 " + repeated("{}", 9'000))},
      {"deep", figure("CHANNELS 0 " + repeated("JOINT b{", 1'900))},
      {"channels", letters},
      {"channels_with_rows", letters + motion + repeated("1 ", 270'000)},
      {"channels_without_line_ends", letters + "MOTION Frames: Frame Time: 1 " + repeated("1 ", 270'000)},
      {"short_numbers", one_joint_file("100000", repeated("1 2 3\n", 100'000))},
      {"frames_unsaid", one_joint_file("", repeated("1 2 3\n", 100'000))},
      {"too_few_frames_said", one_joint_file("1", repeated("1 2 3\n", 100'000))},
      {"too_many_frames_said", one_joint_file("9999999", repeated("1 2 3\n", 100'000))},
      {"one_long_line", one_joint_file("", repeated("1 ", 300'000))},
      {"odd_numbers", one_joint_file("", repeated("1 +1 1e0\n01 1. .1\n", 50'000))},
      {"words", one_joint_file("", repeated("x y z\n", 50'000))},
      {"comments", repeated("#\n", 100'000) + one_joint_file("3", repeated("1 2 3\n#\n", 50'000))},
      {"commas", one_joint_file("", repeated("1,2;3,4;5,6\n", 50'000))},
      {"text_behind", one_joint_file("1", "1 2 3\n" + repeated("x\n", 200'000))},
      {"names", figure("CHANNELS 0" + repeated(" JOINT \xff\xfe\x80{}", 9'000))},
      {"wide_blanks", one_joint_file("", repeated("1\u00a02\u00a03\n", 50'000))},
      {"utf16", "\xff\xfe" + repeated("1\x04", 200'000)},
      {"words_before", repeated("x ", 200'000)},
      {"declared", figure("CHANNELS 2147483647 Zrotation\n") + "MOTION\nFrames: 9999999\nFrame Time: 1\n1\n"},
      {"declared_beyond", figure("CHANNELS 99999999999999999999 Zrotation\n") + "MOTION\nFrames: 99999999999999999999\nFrame Time: 1\n1\n"},
  };
}

class Memory : public testing::TestWithParam<Greedy> {};

TEST_P(Memory, OfReadingIsBoundedByTheFile) {
  const std::string& text = GetParam().text;
  for (const bool strict : {false, true}) {
    const HeapPeak peak;
    (void)read_bvh(text, {.strict = strict, .limits = {}});
    EXPECT_LE(peak.bytes(), most_bytes(text.size())) << text.size();
    if (!strict) RecordProperty("bytes_per_byte", static_cast<int>(peak.bytes() / text.size()));
  }
}

INSTANTIATE_TEST_SUITE_P(Texts, Memory, testing::ValuesIn(greedy_texts()), [](const auto& text) { return text.param.name; });

TEST(TableMemory, OfReadingIsBoundedByTheFile) {
  const BvhClip figure_of_table = read_or_fail(one_joint_file("1", "1 2 3\n"));
  const std::string texts[] = {"a.x" + repeated(",a.x", 9'000) + "\n" + "1", repeated("a,", 300'000), repeated(",", 300'000),
                               "time,a.x\n" + repeated("1,1\n", 100'000), "a.x\n" + repeated("1\n", 200'000),
                               "Hips.Zrotation\n" + repeated("1\n", 200'000), repeated("\"", 300'000)};
  for (const std::string& text : texts) {
    const HeapPeak peak;
    (void)read_points_table(text);
    (void)read_channel_table(text, figure_of_table);
    EXPECT_LE(peak.bytes(), most_bytes(text.size())) << text.substr(0, 20);
  }
}

}  // namespace
}  // namespace marey::test
