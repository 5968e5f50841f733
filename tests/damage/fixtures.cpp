#include "tests/damage/fixtures.h"

#include "core/bvh/text_encoding.h"
#include "tests/core/bvh/bvh_texts.h"
#include "tests/support/files.h"

namespace marey::test {
namespace {

/// The text up to the end of its row number `rows`.
std::string first_rows(const std::string& text, int rows) {
  std::size_t end = text.find("Frame Time");
  for (int line = 0; line <= rows && end < text.size(); ++line) end = text.find('\n', end + 1);
  return end < text.size() ? text.substr(0, end + 1) : text;
}

std::string sample(const std::string& name) { return read_repository_file("web/samples/" + name + ".bvh"); }
std::string printed(const std::string& name) { return read_repository_file("tests/core/bvh/data/" + name + ".bvh"); }

const std::string kNumbers = one_joint_file("4", "1 2 3\n4.5e-3 5 6 # x\n7 8-9\n1\n2 3\nnan 1,5 +7\nend\n");
const std::string kNames = "  JOINT \x8d\xb6\x83{\x81[\x83\x93\n  { OFFSET 0 1 0 CHANNELS 1 Zrotation\n  End Site4 { OFFSET 0 0 1.0 2.0 } }\n";

}  // namespace

std::vector<Fixture> short_fixtures() {
  std::vector<Fixture> fixtures = {
      {"gymnast_as_printed", printed("gymnast_as_printed")},
      {"spine_figures_1_and_2", printed("spine_figures_1_and_2")},
      {"numbers", kNumbers},
      {"channels", file_with_lines("  JOINT b { OFFSET [0, 1, 0] CHANNELS 2 Xscale Grip\n  End Site { OFFSET 0 0 1 } }\n", 8)},
      {"commas", one_joint_file("3", "1,5 2,25 -3,5\r\n1,0;2,5;3\r\n1,5 2,5 3,5\r\n")},
      {"shift_jis", file_with_lines(kNames, 7)},
      {"utf16", encoded_as_utf16(one_joint_file("2", "1 2 3\n4 5 6\n"), TextEncoding::Utf16LittleEndian)},
      {"wide_blanks", replaced(one_joint_file("1", "1\u00a02\u30003\n"), "OFFSET ", "OFFSET\u00a0")},
  };
  for (const std::string name : {"pendulum", "double-pendulum", "robot-arm"}) {
    fixtures.push_back({name, first_rows(sample(name), 3)});
  }
  fixtures.push_back({"walk", first_rows(sample("walk"), 1)});
  for (Fixture& fixture : fixtures) {
    for (char& letter : fixture.name) letter = letter == '-' ? '_' : letter;
  }
  return fixtures;
}

std::vector<Fixture> whole_samples() {
  return {{"double_pendulum", sample("double-pendulum")}, {"robot_arm", sample("robot-arm")}, {"walk", sample("walk")}};
}

}  // namespace marey::test
