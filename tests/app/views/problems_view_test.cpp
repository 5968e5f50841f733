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

TEST_F(Problems, EachJointItsOwnWayIsOfferedWhereTheNumbersDiffer) {
  EXPECT_FALSE(stage_.shows("clip.positions.per_joint@inspector"));
  ASSERT_TRUE(stage_.open_text("mixed.bvh",
                               "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 1 Yposition\n"
                               "JOINT b { OFFSET 0 9 0 CHANNELS 1 Yposition End Site { OFFSET 0 1 0 } }\n"
                               "JOINT c { OFFSET 0 9 0 CHANNELS 1 Yposition End Site { OFFSET 0 1 0 } } }\n"
                               "MOTION\nFrames: 1\nFrame Time: 0.1\n0 0 9.5\n")
                  .ok());
  stage_.app().run_command("view.problems", nullptr);
  stage_.settle();
  EXPECT_EQ(stage_.state()["positionRule"], "per_joint");
  stage_.click("clip.positions.add@inspector");
  EXPECT_EQ(stage_.state()["positionRule"], "add");
  stage_.click("clip.positions.per_joint@inspector");
  EXPECT_EQ(stage_.state()["positionRule"], "per_joint");
}

TEST_F(Problems, AFileThatReadsAsWrittenStillSaysWhatWasAssumed) {
  ASSERT_TRUE(stage_.open_text("plain.bvh", small_bvh(3)).ok());
  stage_.app().run_command("view.problems", nullptr);
  stage_.settle();
  EXPECT_FALSE(stage_.shows("problems.entry.0"));
  EXPECT_TRUE(stage_.shows("clip.up_axis.z@inspector"));
}

TEST_F(Problems, TheUnitIsOneClickAndUndoable) {
  stage_.resize({1280.0f, 1600.0f, 1.0f});
  stage_.settle();
  ASSERT_TRUE(stage_.shows("inspector.metres_per_unit"));
  const double before = stage_.state()["metresPerUnit"];
  stage_.click("clip.unit.inch@inspector");
  EXPECT_EQ(stage_.state()["metresPerUnit"], 0.0254);
  stage_.app().run_command("edit.undo", nullptr);
  EXPECT_EQ(stage_.state()["metresPerUnit"], before);
}

/// A root that stands in a pose of its own and then turns slowly; one row more than declared.
std::string with_reference_pose() {
  std::string text = R"(HIERARCHY
ROOT Root
{
  OFFSET 0 0 0
  CHANNELS 3 Zrotation Xrotation Yrotation
  End Site
  {
    OFFSET 0 10 0
  }
}
MOTION
Frames: 20
Frame Time: 0.05
0 0 0
)";
  for (int frame = 0; frame < 20; ++frame) text += "30 40 " + std::to_string(frame) + "\n";
  return text;
}

TEST_F(Problems, FramesAreLeftOutAndBroughtBackByOneClick) {
  stage_.resize({1280.0f, 2400.0f, 1.0f});
  ASSERT_TRUE(stage_.open_text("reference.bvh", with_reference_pose()).ok());
  stage_.app().run_command("view.problems", nullptr);
  stage_.settle();
  ASSERT_EQ(stage_.state()["frames"], 21);
  stage_.click("clip.frames.declared@inspector");
  EXPECT_EQ(stage_.state()["frames"], 20);
  stage_.click("clip.frames.all@inspector");
  EXPECT_EQ(stage_.state()["frames"], 21);
  stage_.click("clip.first_frame.leave_out@inspector");
  EXPECT_EQ(stage_.state()["frames"], 20);
  EXPECT_EQ(stage_.state()["undoName"], "Leave out frame 1");
  stage_.click("clip.first_frame.keep@inspector");
  EXPECT_EQ(stage_.state()["frames"], 21);
  EXPECT_EQ(stage_.state()["dirty"], false);
}

TEST_F(Problems, AFindingOfTheLinterLeadsToItsPlace) {
  stage_.resize({1280.0f, 2400.0f, 1.0f});
  std::string text = with_reference_pose();
  ASSERT_TRUE(stage_.open_text("reference.bvh", text).ok());
  stage_.app().run_command("play.go_to_frame", {{"frame", 7}});
  stage_.app().run_command("view.problems", nullptr);
  stage_.settle();
  ASSERT_TRUE(stage_.shows("problems.finding.0"));
  EXPECT_NE(stage_.item("problems.finding.0").label.find("Frame 1 is a pose of its own"), std::string::npos);
  stage_.click("problems.finding.0");
  EXPECT_EQ(stage_.state()["frame"], 0);
}

}  // namespace
}  // namespace marey::app
