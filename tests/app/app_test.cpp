#include "wasm/app/app.h"

#include <gtest/gtest.h>

#include "tests/app/support/app_stage.h"

namespace marey::app {
namespace {

TEST(OpenFile, ABrokenFileLeavesTheDocumentAndSaysWhere) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("good.bvh", small_bvh(5)).ok());
  const Status refused = stage.open_text("bad.bvh", "this is no motion capture");
  EXPECT_FALSE(refused.ok());
  const auto state = stage.state();
  EXPECT_EQ(state["file"], "good.bvh");
  EXPECT_EQ(state["frames"], 5);
  ASSERT_EQ(state["messages"].size(), 1u);
  EXPECT_NE(state["messages"][0]["title"].get<std::string>().find("bad.bvh"), std::string::npos);
  EXPECT_FALSE(state["messages"][0]["detail"].get<std::string>().empty());
  EXPECT_TRUE(stage.shows("message.text"));
  EXPECT_NE(stage.log().announcements.back().find("bad.bvh"), std::string::npos);
}

TEST(OpenFile, MessagesStayUntilClosed) {
  AppStage stage;
  EXPECT_FALSE(stage.open_text("bad.bvh", "").ok());
  stage.wait(60.0);
  stage.settle();
  EXPECT_TRUE(stage.shows("message.text"));
  stage.click("message.close");
  EXPECT_FALSE(stage.shows("message.text"));
}

TEST(OpenFile, TheSameMessageDoesNotPileUp) {
  AppStage stage;
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(stage.open_text("bad.bvh", "").ok());
  EXPECT_EQ(stage.state()["messages"].size(), 1u);
}

TEST(OpenFile, SuccessIsAnnouncedWithItsContents) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("five.bvh", small_bvh(5)).ok());
  const std::string said = stage.log().announcements.back();
  EXPECT_NE(said.find("3 joints"), std::string::npos) << said;
  EXPECT_NE(said.find("5 frames"), std::string::npos) << said;
  EXPECT_EQ(stage.log().file_name, "five.bvh");
}

TEST(OpenFile, StateTellsWhatIsOpen) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("five.bvh", small_bvh(5)).ok());
  const auto state = stage.state();
  ASSERT_EQ(state["joints"].size(), 3u);
  EXPECT_EQ(state["joints"][1]["name"], "Middle");
  EXPECT_EQ(state["joints"][1]["parent"], 0);
  EXPECT_EQ(state["joints"][0]["channels"].size(), 6u);
  EXPECT_EQ(state["frame"], 0);
  EXPECT_DOUBLE_EQ(state["frameTime"], 0.1);
  EXPECT_EQ(state["dirty"], false);
  EXPECT_TRUE(state["undoName"].is_null());
}

TEST(OpenFile, ChangesThatWereNotDownloadedAreNotLost) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("first.bvh", small_bvh(5)).ok());
  stage.app().run_command("clip.frame_time", {{"seconds", 0.5}});
  ASSERT_TRUE(stage.open_text("second.bvh", small_bvh(3)).ok());
  ASSERT_EQ(stage.state()["messages"].size(), 1u);
  stage.click("file.previous.message");
  EXPECT_EQ(stage.state()["file"], "first.bvh");
  EXPECT_DOUBLE_EQ(stage.state()["frameTime"], 0.5);
  EXPECT_EQ(stage.state()["undoDepth"], 1);
  EXPECT_TRUE(stage.state()["messages"].empty());
}

TEST(OpenFile, WithoutChangesNothingIsKept) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("first.bvh", small_bvh(5)).ok());
  ASSERT_TRUE(stage.open_text("second.bvh", small_bvh(3)).ok());
  EXPECT_TRUE(stage.state()["messages"].empty());
  EXPECT_TRUE(stage.app().run_command("file.previous", nullptr).contains("error"));
}

TEST(Idle, NoFramesAreWantedAtRest) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("five.bvh", small_bvh(5)).ok());
  stage.wait(10.0);
  EXPECT_LT(stage.settle(600), 600);
  EXPECT_FALSE(stage.frame());
  EXPECT_FALSE(stage.frame());
}

TEST(Idle, PlayingWantsFramesAndPausingStops) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("five.bvh", small_bvh(5)).ok());
  stage.press(ImGuiKey_Space);
  EXPECT_TRUE(stage.state()["playing"].get<bool>());
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(stage.frame());
  EXPECT_GT(stage.state()["frame"].get<int>(), 0);
  stage.press(ImGuiKey_Space);
  stage.wait(10.0);
  stage.settle(600);
  EXPECT_FALSE(stage.frame());
}

TEST(Idle, PointerOverAPanelComesToRest) {
  AppStage stage;
  stage.open_sample("walk");
  stage.hover("edit.undo");
  EXPECT_LT(stage.settle(600), 600);
}

TEST(Preferences, AreStoredOnceAtRestAndReadOnTheNextVisit) {
  AppStage stage;
  stage.app().run_command("view.theme.light", nullptr);
  stage.settle();
  const std::string stored = stage.log().preferences;
  EXPECT_NE(stored.find("light"), std::string::npos);
  const int writes = stage.log().preference_writes;
  stage.settle();
  EXPECT_EQ(stage.log().preference_writes, writes);
}

TEST(Notice, GoesByItselfOnAPageAtRest) {
  AppStage stage;
  stage.open_sample("pendulum");
  const std::string shown = stage.state()["status"];
  EXPECT_NE(shown.find("Opened pendulum.bvh"), std::string::npos);
  ASSERT_GT(stage.log().draw_after_s, 0.0);
  stage.wait(stage.log().draw_after_s);
  stage.frame();
  EXPECT_EQ(stage.state()["status"], "");
}

TEST(Preferences, AreStoredWhileAClipPlays) {
  AppStage stage({}, "{}");
  stage.open_sample("walk");
  stage.press(ImGuiKey_Escape);
  ASSERT_EQ(stage.state()["playing"], true);
  EXPECT_NE(stage.log().preferences.find(R"("welcomeSeen":true)"), std::string::npos) << stage.log().preferences;
}

TEST(Touch, MakesControlsLargerOnceTheFingerIsLifted) {
  AppStage stage;
  stage.open_sample("pendulum");
  const float before = stage.item("play.toggle").min.y;
  const ImVec2 place = center_of(stage.app().items(), "play.toggle");
  ImGui::GetIO().AddMouseSourceEvent(ImGuiMouseSource_TouchScreen);
  ImGuiStage::move_mouse(place);
  ImGuiStage::press_mouse(true);
  for (int i = 0; i < 4; ++i) stage.frame();
  EXPECT_EQ(stage.item("play.toggle").min.y, before) << "it moves away under the finger";
  ImGuiStage::press_mouse(false);
  for (int i = 0; i < 4; ++i) stage.frame();
  EXPECT_EQ(stage.state()["playing"], true);
  EXPECT_LT(stage.item("play.toggle").min.y, before);
}

TEST(Preferences, OfALastVisitAreUsed) {
  AppStage stage({}, R"({"welcomeSeen":true,"theme":"light","interfaceScale":1.5})");
  EXPECT_EQ(stage.state()["theme"], "light");
  EXPECT_FLOAT_EQ(stage.app().css_per_unit(), 1.5f);
}

TEST(Theme, FollowsTheSystemUnlessChosen) {
  AppStage stage;
  stage.log().system.dark = false;
  stage.frame();
  EXPECT_EQ(stage.state()["theme"], "light");
  stage.app().run_command("view.theme.dark", nullptr);
  stage.frame();
  EXPECT_EQ(stage.state()["theme"], "dark");
}

TEST(Escape, LeavesTheInnermostThingFirst) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("five.bvh", small_bvh(5)).ok());
  EXPECT_FALSE(stage.open_text("bad.bvh", "").ok());
  stage.app().run_command("select.joint", {{"joint", 1}});
  stage.app().run_command("help.about", nullptr);
  stage.settle(10);
  stage.press(ImGuiKey_Escape);
  EXPECT_EQ(stage.state()["overlay"], "none");
  EXPECT_EQ(stage.state()["messages"].size(), 1u);
  stage.press(ImGuiKey_Escape);
  EXPECT_TRUE(stage.state()["messages"].empty());
  EXPECT_EQ(stage.state()["selection"]["joints"].size(), 1u);
  stage.press(ImGuiKey_Escape);
  EXPECT_TRUE(stage.state()["selection"]["joints"].empty());
}

TEST(Keyboard, ArrowsStepThroughFrames) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("five.bvh", small_bvh(5)).ok());
  stage.press(ImGuiKey_RightArrow);
  stage.press(ImGuiKey_RightArrow);
  EXPECT_EQ(stage.state()["frame"], 2);
  stage.press(ImGuiKey_LeftArrow);
  EXPECT_EQ(stage.state()["frame"], 1);
  stage.press(ImGuiKey_End);
  EXPECT_EQ(stage.state()["frame"], 4);
}

TEST(Keyboard, SpacePlaysAfterAClickOnAButton) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("five.bvh", small_bvh(5)).ok());
  stage.click("play.loop");
  stage.press(ImGuiKey_Space);
  EXPECT_TRUE(stage.state()["playing"].get<bool>());
}

}  // namespace
}  // namespace marey::app
