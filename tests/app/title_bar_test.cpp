#include <gtest/gtest.h>

#include "tests/app/support/app_stage.h"

namespace marey::app {
namespace {

TEST(TitleBar, UndoAndRedoByTheirButtons) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("five.bvh", small_bvh(5)).ok());
  stage.app().run_command("clip.frame_time", {{"seconds", 0.5}});
  stage.settle();
  EXPECT_DOUBLE_EQ(stage.state()["frameTime"], 0.5);
  stage.click("edit.undo");
  EXPECT_DOUBLE_EQ(stage.state()["frameTime"], 0.1);
  EXPECT_EQ(stage.state()["redoDepth"], 1);
  stage.click("edit.redo");
  EXPECT_DOUBLE_EQ(stage.state()["frameTime"], 0.5);
}

TEST(TitleBar, UndoByShortcutNamesTheStep) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("five.bvh", small_bvh(5)).ok());
  stage.app().run_command("clip.frame_time", {{"seconds", 0.5}});
  stage.press(ImGuiMod_Ctrl | ImGuiKey_Z);
  EXPECT_EQ(stage.state()["undoDepth"], 0);
  EXPECT_NE(stage.log().announcements.back().find("frame time"), std::string::npos);
  stage.press(ImGuiMod_Ctrl | ImGuiKey_Y);
  EXPECT_EQ(stage.state()["undoDepth"], 1);
}

TEST(TitleBar, MarksUnsavedChanges) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("five.bvh", small_bvh(5)).ok());
  EXPECT_FALSE(stage.shows("title.unsaved"));
  stage.app().run_command("clip.frame_time", {{"seconds", 0.5}});
  stage.settle();
  EXPECT_TRUE(stage.shows("title.unsaved"));
  stage.click("edit.undo");
  EXPECT_FALSE(stage.shows("title.unsaved"));
}

TEST(TitleBar, DownloadButtonDownloads) {
  AppStage stage;
  stage.open_sample("pendulum");
  stage.click("file.save");
  ASSERT_EQ(stage.log().downloads.size(), 1u);
  EXPECT_EQ(stage.log().downloads[0].first, "pendulum.bvh");
}

TEST(Menus, OpenByClickAndRunACommand) {
  AppStage stage;
  stage.open_sample("pendulum");
  stage.click("menu.File");
  ASSERT_TRUE(stage.shows("menu.file.open"));
  stage.click("menu.file.open");
  EXPECT_EQ(stage.log().file_requests, 1);
  EXPECT_FALSE(stage.shows("menu.file.open"));
}

TEST(Menus, FollowThePointerOnceOneIsOpen) {
  AppStage stage;
  stage.open_sample("pendulum");
  stage.click("menu.File");
  stage.hover("menu.View");
  for (int i = 0; i < 4; ++i) stage.frame();
  EXPECT_TRUE(stage.shows("menu.view.grid"));
  EXPECT_FALSE(stage.shows("menu.file.open"));
}

TEST(Menus, ArrowKeysGoToTheNeighbour) {
  AppStage stage;
  stage.open_sample("pendulum");
  stage.click("menu.File");
  stage.press(ImGuiKey_RightArrow);
  EXPECT_TRUE(stage.shows("menu.edit.undo"));
  stage.press(ImGuiKey_LeftArrow);
  EXPECT_TRUE(stage.shows("menu.file.open"));
  EXPECT_EQ(stage.state()["frame"], 0) << "the arrow also stepped the frame";
}

TEST(Menus, EscapeClosesThem) {
  AppStage stage;
  stage.open_sample("pendulum");
  stage.click("menu.Edit");
  stage.press(ImGuiKey_Escape);
  EXPECT_FALSE(stage.shows("menu.edit.undo"));
}

TEST(Menus, BlockedEntriesDoNothing) {
  AppStage stage;
  stage.open_sample("pendulum");
  stage.click("menu.Edit");
  stage.click("menu.edit.undo");
  EXPECT_TRUE(stage.shows("menu.edit.undo"));
}

TEST(Menus, EveryMenuFitsIntoTheWindow) {
  AppStage stage;
  stage.open_sample("walk");
  for (const char* menu : {"menu.File", "menu.Edit", "menu.Clip", "menu.View", "menu.Analyse", "menu.Help"}) {
    stage.click(menu);
    for (const UiItem& item : stage.app().items().list()) {
      EXPECT_GE(item.min.x, 0.0f) << item.id;
      EXPECT_LE(item.max.x, 1280.0f) << item.id;
      EXPECT_LE(item.max.y, 800.0f) << item.id;
    }
    stage.press(ImGuiKey_Escape);
  }
}

}  // namespace
}  // namespace marey::app
