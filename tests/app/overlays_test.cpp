#include <gtest/gtest.h>

#include "tests/app/support/app_stage.h"
#include "wasm/app/samples.h"

namespace marey::app {
namespace {

TEST(Palette, FindsACommandAndRunsItWithEnter) {
  AppStage stage;
  stage.open_sample("pendulum");
  stage.press(ImGuiMod_Ctrl | ImGuiKey_K);
  ASSERT_TRUE(stage.shows("palette.query"));
  stage.type("light th");
  stage.press(ImGuiKey_Enter);
  EXPECT_EQ(stage.state()["theme"], "light");
  EXPECT_EQ(stage.state()["overlay"], "none");
}

TEST(Palette, ArrowsChooseTheNextEntry) {
  AppStage stage;
  stage.open_sample("pendulum");
  stage.press(ImGuiMod_Ctrl | ImGuiKey_K);
  stage.type("theme");
  ASSERT_LT(stage.item("palette.view.theme.light").min.y, stage.item("palette.view.theme.dark").min.y);
  stage.press(ImGuiKey_DownArrow);
  stage.press(ImGuiKey_Enter);
  EXPECT_EQ(stage.state()["themeChoice"], "dark");
}

TEST(Palette, LettersAreNoShortcutsWhileTyping) {
  AppStage stage;
  stage.open_sample("pendulum");
  stage.press(ImGuiMod_Ctrl | ImGuiKey_K);
  stage.press(ImGuiKey_Space);
  stage.press(ImGuiKey_G);
  EXPECT_EQ(stage.state()["playing"], false);
  EXPECT_EQ(stage.state()["overlay"], "palette");
}

TEST(Palette, BlockedCommandStaysAndSaysWhy) {
  AppStage stage;
  stage.open_sample("pendulum");
  stage.press(ImGuiMod_Ctrl | ImGuiKey_K);
  stage.type("undo");
  stage.press(ImGuiKey_Enter);
  EXPECT_EQ(stage.state()["overlay"], "palette");
  EXPECT_TRUE(stage.shows("palette.edit.undo"));
}

TEST(Palette, EscapeAndAClickBesideCloseIt) {
  AppStage stage;
  stage.open_sample("pendulum");
  stage.press(ImGuiMod_Ctrl | ImGuiKey_K);
  stage.press(ImGuiKey_Escape);
  EXPECT_EQ(stage.state()["overlay"], "none");
  stage.click("help.commands");
  EXPECT_EQ(stage.state()["overlay"], "palette");
  stage.click_at(ImVec2(30.0f, 760.0f));
  EXPECT_EQ(stage.state()["overlay"], "none");
}

TEST(Palette, OpensEmptyEachTime) {
  AppStage stage;
  stage.open_sample("pendulum");
  stage.press(ImGuiMod_Ctrl | ImGuiKey_K);
  stage.type("zzzz");
  stage.press(ImGuiKey_Escape);
  stage.press(ImGuiMod_Ctrl | ImGuiKey_K);
  EXPECT_TRUE(stage.shows("palette.file.open"));
}

TEST(Shortcuts, SheetListsEveryCommandWithAShortcut) {
  AppStage stage({1280.0f, 1000.0f, 1.0f});
  stage.open_sample("pendulum");
  stage.press(ImGuiMod_Shift | ImGuiKey_Slash);
  ASSERT_EQ(stage.state()["overlay"], "shortcuts");
  int listed = 0;
  for (const UiItem& item : stage.app().items().list()) listed += item.id.starts_with("shortcuts.") ? 1 : 0;
  EXPECT_GE(listed, 20);
  stage.click("shortcuts.close");
  EXPECT_EQ(stage.state()["overlay"], "none");
}

TEST(About, SaysThatNothingLeavesTheComputer) {
  AppStage stage;
  stage.app().run_command("help.about", nullptr);
  stage.settle(10);
  const UiItem& privacy = stage.item("about.privacy");
  EXPECT_NE(privacy.label.find("Nothing leaves this computer"), std::string::npos);
  stage.click("about.licences");
  EXPECT_EQ(stage.state()["overlay"], "about");
}

TEST(Welcome, FirstVisitShowsTheSamplesOverAPlayingFigure) {
  AppStage stage({}, "");
  stage.open_sample("walk");
  EXPECT_EQ(stage.state()["overlay"], "welcome");
  EXPECT_EQ(stage.state()["playing"], true);
  for (const Sample& sample : kSamples) EXPECT_TRUE(stage.shows("welcome." + std::string(sample.id)));
}

TEST(Welcome, ASampleIsChosenByClickAndTheWelcomeDoesNotComeBack) {
  AppStage stage({}, "");
  stage.open_sample("walk");
  stage.click("welcome.robot-arm");
  ASSERT_EQ(stage.log().samples, std::vector<std::string>{"robot-arm"});
  EXPECT_EQ(stage.state()["overlay"], "none");
  stage.app().run_command("play.toggle", nullptr);
  stage.settle();
  stage.wait(10.0);
  stage.settle();
  EXPECT_NE(stage.log().preferences.find("\"welcomeSeen\":true"), std::string::npos);
}

TEST(Welcome, OpeningAnOwnFileClosesIt) {
  AppStage stage({}, "");
  ASSERT_TRUE(stage.open_text("mine.bvh", small_bvh(3)).ok());
  EXPECT_EQ(stage.state()["overlay"], "none");
  EXPECT_EQ(stage.state()["playing"], false);
}

}  // namespace
}  // namespace marey::app
