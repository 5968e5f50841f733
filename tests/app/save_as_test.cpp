#include <gtest/gtest.h>

#include "tests/app/support/app_stage.h"

namespace marey::app {
namespace {

class SaveAsTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(stage_.open_text("small.bvh", small_bvh(5)).ok()); }

  nlohmann::json run(const nlohmann::json& args) { return stage_.app().run_command("file.save_as", args); }

  AppStage stage_;
};

TEST_F(SaveAsTest, OpensADialogThatSaysThatNothingDiffers) {
  stage_.press(ImGuiMod_Ctrl | ImGuiMod_Shift | ImGuiKey_S);
  stage_.settle();
  EXPECT_EQ(stage_.state()["overlay"], "save_as");
  EXPECT_NE(stage_.item("save_as.difference.0").label.find("In nothing"), std::string::npos);
  EXPECT_EQ(stage_.item("save_as.name").label, "small.bvh");
  stage_.click("save_as.download");
  EXPECT_EQ(stage_.state()["overlay"], "none");
  ASSERT_EQ(stage_.log().downloads.size(), 1u);
  EXPECT_EQ(stage_.log().downloads[0].second, small_bvh(5));
}

TEST_F(SaveAsTest, ATargetIsChosenFromTheListAndTold) {
  stage_.app().run_command("file.save_as", nullptr);
  stage_.settle();
  stage_.click("save_as.form");
  stage_.click("save_as.form.blender");
  EXPECT_EQ(stage_.item("save_as.name").label, "small-blender.bvh");
  stage_.click("save_as.download");
  ASSERT_EQ(stage_.log().downloads.size(), 1u);
  EXPECT_EQ(stage_.log().downloads[0].first, "small-blender.bvh");
}

TEST_F(SaveAsTest, TakesDecimalsLineEndsAndFrames) {
  const nlohmann::json answer = run({{"decimals", 2}, {"lineEnds", "crlf"}, {"first", 1}, {"count", 3}});
  ASSERT_EQ(answer["name"], "small.bvh");
  const std::string& text = stage_.log().downloads.at(0).second;
  EXPECT_NE(text.find("Frames: 3\r\n"), std::string::npos);
  EXPECT_EQ(text.find("\n") == text.find("\r\n") + 1, true);
  EXPECT_EQ(answer["notes"].size(), 3u) << answer;
}

TEST_F(SaveAsTest, ACopyThatIsNotWholeLeavesTheClipUnsaved) {
  stage_.app().run_command("clip.frame_time", {{"seconds", 0.5}});
  ASSERT_EQ(stage_.state()["dirty"], true);
  run({{"form", "channels"}});
  run({{"form", "positions"}});
  run({{"decimals", 3}});
  run({{"target", "three"}});
  EXPECT_EQ(stage_.state()["dirty"], true);
  run({{"lineEnds", "lf"}});
  EXPECT_EQ(stage_.state()["dirty"], false);
  EXPECT_EQ(stage_.log().downloads.at(0).first, "small-channels.csv");
  EXPECT_EQ(stage_.log().downloads.at(1).first, "small-positions.csv");
  EXPECT_EQ(stage_.log().downloads.at(3).first, "small-three.bvh");
}

TEST_F(SaveAsTest, RefusesWhatItDoesNotKnow) {
  for (const nlohmann::json& args : {nlohmann::json{{"form", "fbx"}}, nlohmann::json{{"target", "maya7"}},
                                     nlohmann::json{{"lineEnds", "cr"}}, nlohmann::json{{"decimals", -1}},
                                     nlohmann::json{{"first", 5}}, nlohmann::json{{"first", 0}, {"count", 6}}}) {
    EXPECT_TRUE(run(args).contains("error")) << args;
  }
  EXPECT_TRUE(stage_.log().downloads.empty());
}

TEST_F(SaveAsTest, AClipWithoutFramesHasNoPartToSave) {
  ASSERT_TRUE(stage_.open_text("none.bvh", small_bvh(0)).ok());
  EXPECT_TRUE(run({{"first", 0}, {"form", "channels"}}).contains("error"));
  EXPECT_TRUE(stage_.log().downloads.empty());
}

TEST_F(SaveAsTest, TellsOfTheClipThatIsOpen) {
  const auto difference = [&] {
    stage_.app().run_command("file.save_as", nullptr);
    stage_.settle();
    return stage_.item("save_as.difference.0").label;
  };
  stage_.app().run_command("clip.frame_time", {{"seconds", 0.5}});
  EXPECT_EQ(difference(), "Your changes: the frame time.");
  ASSERT_TRUE(stage_.open_text("other.bvh", small_bvh(4)).ok());
  stage_.app().run_command("clip.remove_frames", {{"first", 0}, {"count", 1}});
  EXPECT_EQ(difference(), "Your changes: 1 frame left out.");
}

}  // namespace
}  // namespace marey::app
