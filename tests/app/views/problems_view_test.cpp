#include <gtest/gtest.h>

#include "tests/app/support/app_stage.h"

namespace marey::app {
namespace {

/// A root whose OFFSET and position channels disagree, and a bad number in its second row.
constexpr const char* kDoubtful = R"(HIERARCHY
ROOT Root
{
  OFFSET 1 2 3
  CHANNELS 3 Xposition Yposition Zposition
  End Site
  {
    OFFSET 0 10 0
  }
}
MOTION
Frames: 2
Frame Time: 0.1
4 5 6
4 x5 6
)";

class Problems : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(stage_.open_text("doubtful.bvh", kDoubtful).ok());
    stage_.app().run_command("view.problems", nullptr);
    stage_.settle();
  }

  std::string entry_of(const std::string& code) {
    const nlohmann::json list = stage_.state()["diagnostics"];
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i]["code"] == code) return std::to_string(i);
    }
    ADD_FAILURE() << "no " << code << " in " << list;
    return "0";
  }

  AppStage stage_;
};

TEST_F(Problems, AClickShowsThePlaceInTheText) {
  const std::string index = entry_of("bad_number");
  EXPECT_FALSE(stage_.shows("problems.excerpt." + index));
  stage_.click("problems.entry." + index);
  ASSERT_TRUE(stage_.shows("problems.excerpt." + index));
  EXPECT_EQ(stage_.item("problems.excerpt." + index).label, "4 x5 6");
  stage_.click("problems.entry." + index);
  EXPECT_FALSE(stage_.shows("problems.excerpt." + index));
}

TEST_F(Problems, AnotherWayOfReadingIsOneClickAndUndoable) {
  ASSERT_EQ(stage_.state()["positionRule"], "replace");
  stage_.click("clip.positions.add@inspector");
  EXPECT_EQ(stage_.state()["positionRule"], "add");
  stage_.app().run_command("edit.undo", nullptr);
  EXPECT_EQ(stage_.state()["positionRule"], "replace");
}

TEST_F(Problems, AFileThatReadsAsWrittenStillSaysWhatWasAssumed) {
  ASSERT_TRUE(stage_.open_text("plain.bvh", small_bvh(3)).ok());
  stage_.app().run_command("view.problems", nullptr);
  stage_.settle();
  EXPECT_FALSE(stage_.shows("problems.entry.0"));
  EXPECT_TRUE(stage_.shows("clip.up_axis.z@inspector"));
  EXPECT_TRUE(stage_.shows("inspector.metres_per_unit"));
}

}  // namespace
}  // namespace marey::app
