// A repair of the header changes its place and leaves the rest of the text as it was, comments and byte order mark too.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/core/bvh/bvh_texts.h"

namespace marey {
namespace {

using namespace test;

constexpr std::string_view kMark = "\xef\xbb\xbf";

/// A sound file with a byte order mark, comments and uneven blanks.
std::string commented_file() {
  const std::string text = replaced(file_with_lines(kChild, 9), "  JOINT", "  # the chest\n\n  JOINT");
  return std::string(kMark) + "# recorded in May\n" + replaced(text, "OFFSET 0 6 0", "OFFSET  0\t6 0");
}

struct Repair {
  std::string sound;   ///< a piece of commented_file()
  std::string broken;  ///< what stands there instead
  std::string repaired;  ///< what is written, if not `sound`
};

std::vector<Repair> repairs() {
  return {
      {"OFFSET 0 5 0", "OFFSET [0, 5, 0]", ""},
      {"OFFSET 0 5 0", "OFFSET 0 5 0 x y", ""},
      {"OFFSET 0 5 0", "OFFSET 0 5", ""},
      {"OFFSET 0 5 0", "OFFSET", "OFFSET 0 0 0"},
      {"OFFSET 0 5 0", "OFFSET 0 0 5.0 0.0", "OFFSET 0.0 5.0 0.0"},
      {"OFFSET 0 5 0", "OFFSET nan 5x 0", ""},
      {"OFFSET 0 5 0", "OFFSET 0 5-1", "OFFSET 0 5 -1"},
      {"OFFSET 0 5 0", "OFFSET: 0 5 0", ""},
      {"OFFSET 0 5 0", "OFSET 0 5 0", ""},
      {"    OFFSET 0 5 0\n", "    OFFSET 1 2 3\n    OFFSET 0 5 0\n", ""},
      {"CHANNELS 3", "CHANNELS 4", ""},
      {"CHANNELS 3", "CHANNELS", ""},
      {"CHANNELS 3", "CHANNELS -1", ""},
      {"  JOINT Chest\n  {\n    OFFSET", "  JOINT Chest\n    OFFSET", "  JOINT Chest\n    {\n    OFFSET"},
      {"  }\n}\nMOTION", "  }\nMOTION", ""},
      {"}\nMOTION", "}\n} }\n}\nMOTION", ""},
      {"    End Site", "    x y\n    z\n    End Site", ""},
      {"    End Site", "    q End Site", ""},
      {"End Site", "End_Site", ""},
      {"End Site", "End", ""},
      {"MOTION\n", "", ""},
      {"MOTION\n", "MOTION\nTake 7\n", ""},
      {"Frames: 1\n", "", ""},
      {"Frames: 1", "Frames: many", ""},
      {"Frames: 1", "Frames 1", ""},
      {"Frames: 1\n", "Frames: 9\nFrames: 1\n", ""},
      {"Frame Time: 0.04\n", "", "Frame Time: 0.03333333333333333\n"},
      {"Frame Time: 0.04", "Frame Time = 0.04", ""},
      {"Frame Time: 0.04", "Frame Rate: 25", ""},
      {"Frame Time: 0.04\n", "Frame Time: 1\nFrame Time: 0.04\n", ""},
      {"ROOT Hips", "JOINT Hips", ""},
      {"HIERARCHY\n", "", ""},
      {"HIERARCHY\n", "made by hand\nHIERARCHY\n", ""},
  };
}

TEST(HeaderRepair, ChangesNothingButItsPlace) {
  for (const std::string_view line_end : {"\n", "\r\n"}) {
    for (const Repair& repair : repairs()) {
      SCOPED_TRACE(repair.broken);
      ASSERT_NE(commented_file().find(repair.sound), std::string::npos) << repair.sound;
      const std::string broken = replaced(replaced(commented_file(), repair.sound, repair.broken), "\n", line_end);
      const std::string& piece = repair.repaired.empty() ? repair.sound : repair.repaired;
      const std::string expected = replaced(replaced(commented_file(), repair.sound, piece), "\n", line_end);
      EXPECT_EQ(written(read_or_fail(broken)), expected);
    }
  }
}

TEST(HeaderRepair, SeveralAtOnce) {
  std::string broken = commented_file();
  broken = replaced(broken, "OFFSET 0 5 0", "OFFSET [0 5 0]");
  broken = replaced(broken, "CHANNELS 3", "CHANNELS 2");
  broken = replaced(broken, "End Site", "x\n    End_Site");
  broken = replaced(broken, "MOTION\nFrames: 1\n", "} q\n");
  EXPECT_EQ(written(read_or_fail(broken)), commented_file());
}

TEST(HeaderRepair, KeepsNumbersEditableInTheirPlaces) {
  BvhClip clip = read_or_fail(replaced(commented_file(), "OFFSET 0 5 0", "OFFSET [0, 5, 0]"));
  clip.skeleton.set_offset(1, {0.5, 5, -1});
  clip.motion.set_frame_time_s(0.25);
  EXPECT_EQ(written(clip), replaced(replaced(commented_file(), "OFFSET 0 5 0", "OFFSET 0.5 5 -1"), "0.04", "0.25"));
}

TEST(HeaderRepair, OfAnotherTreePrintsItAnewBelowItsComments) {
  const std::string early = replaced(commented_file(), "    CHANNELS 3 Zrotation Xrotation Yrotation\n",
                                     "    CHANNELS 3 Zrotation Xrotation Yrotation\n  }\n");
  const std::string text = written(read_or_fail(early));
  EXPECT_EQ(text.substr(0, 31), std::string(kMark) + "# recorded in May\nHIERARCHY\n");
  EXPECT_EQ(text.find("the chest"), std::string::npos);
  EXPECT_EQ(rows_of(read_or_fail(text)), rows_of(read_or_fail(commented_file())));
}

}  // namespace
}  // namespace marey
