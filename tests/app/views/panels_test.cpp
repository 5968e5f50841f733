#include <gtest/gtest.h>

#include <string>

#include "tests/app/support/app_stage.h"

namespace marey::app {
namespace {

TEST(OutlinerView, AClickSelectsAndShiftSelectsARun) {
  AppStage stage;
  stage.open_sample("walk");
  stage.settle();
  stage.click("outliner.joint.2");
  EXPECT_EQ(stage.state()["selection"]["activeJoint"], 2);
  ImGuiStage::key_event(ImGuiMod_Shift, true);
  stage.frame();
  stage.click("outliner.joint.5");
  ImGuiStage::key_event(ImGuiMod_Shift, false);
  stage.settle();
  EXPECT_EQ(stage.state()["selection"]["joints"].size(), 4u);
}

TEST(OutlinerView, FoldingHidesTheSubtree) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("small.bvh", small_bvh()).ok());
  stage.settle();
  ASSERT_TRUE(stage.shows("outliner.joint.2"));
  stage.click("outliner.fold.0");
  EXPECT_TRUE(stage.shows("outliner.joint.0"));
  EXPECT_FALSE(stage.shows("outliner.joint.1"));
  EXPECT_FALSE(stage.shows("outliner.joint.2"));
}

TEST(OutlinerView, SearchKeepsMatchesAndTheirParents) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("small.bvh", small_bvh(5, "Hand")).ok());
  stage.settle();
  stage.click("outliner.search");
  stage.type("mid");
  stage.settle();
  EXPECT_TRUE(stage.shows("outliner.joint.0"));
  EXPECT_TRUE(stage.shows("outliner.joint.1"));
  EXPECT_FALSE(stage.shows("outliner.joint.2"));
}

TEST(TimelineView, ADragOnTheRulerScrubs) {
  AppStage stage;
  stage.open_sample("giant-swing");
  stage.settle();
  const UiItem ruler = stage.item("timeline.ruler");
  const float y = 0.5f * (ruler.min.y + ruler.max.y) - 6.0f;
  stage.click_at({ruler.max.x - 2.0f, y});
  EXPECT_EQ(stage.state()["frame"], 22);
  stage.click_at({ruler.min.x + 2.0f, y});
  EXPECT_EQ(stage.state()["frame"], 0);
}

TEST(TimelineView, TheRangeHandlesSetWhatPlays) {
  AppStage stage;
  stage.open_sample("giant-swing");
  stage.settle();
  stage.drag("timeline.range_in", {200.0f, 0.0f});
  EXPECT_GT(stage.state()["range"]["first"].get<int>(), 0);
  stage.drag("timeline.range_out", {-200.0f, 0.0f});
  const auto range = stage.state()["range"];
  EXPECT_LT(range["first"].get<int>() + range["count"].get<int>(), 23);
}

TEST(TransportView, TheFrameFieldGoesToAFrame) {
  AppStage stage;
  stage.open_sample("giant-swing");
  stage.settle();
  stage.double_click("play.frame");
  stage.press(ImGuiMod_Ctrl | ImGuiKey_A);
  stage.type("12");
  stage.press(ImGuiKey_Enter);
  EXPECT_EQ(stage.state()["frame"], 11) << "people count from 1";
}

TEST(InspectorView, ATypedChannelChangesTheSampleAtTheFrame) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("small.bvh", small_bvh()).ok());
  stage.settle();
  stage.click("outliner.joint.0");
  stage.click("inspector.tab.joint");
  stage.double_click("inspector.channel.3");
  stage.press(ImGuiMod_Ctrl | ImGuiKey_A);
  stage.type("33.25");
  stage.press(ImGuiKey_Enter);
  EXPECT_EQ(stage.app().session().document.motion().sample(3, 0), 33.25);
  EXPECT_EQ(stage.state()["undoDepth"], 1);
}

TEST(InspectorView, ATypedOffsetMovesTheJointAndIsUndone) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("small.bvh", small_bvh()).ok());
  stage.settle();
  stage.click("outliner.joint.1");
  stage.resize({1280.0f, 1200.0f, 1.0f});
  stage.settle();
  const Skeleton& skeleton = stage.app().session().document.skeleton();
  const double before = skeleton.offset(1).y;
  const std::string field = "inspector.offset." + std::to_string(skeleton.node_of(1)) + ".1";
  stage.double_click(field);
  stage.press(ImGuiMod_Ctrl | ImGuiKey_A);
  stage.type("7.5");
  stage.press(ImGuiKey_Enter);
  EXPECT_EQ(stage.app().session().document.skeleton().offset(1).y, 7.5);
  stage.app().run_command("edit.undo", nullptr);
  EXPECT_EQ(stage.app().session().document.skeleton().offset(1).y, before);
}

TEST(InspectorView, TheClipPageChangesHowPositionsAreRead) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("small.bvh", small_bvh()).ok());
  stage.settle();
  stage.resize({1280.0f, 1200.0f, 1.0f});
  stage.settle();
  stage.click("inspector.tab.clip");
  EXPECT_EQ(stage.state()["positionRule"], "replace");
  stage.click("clip.positions.add@inspector");
  EXPECT_EQ(stage.state()["positionRule"], "add");
  stage.app().run_command("edit.undo", nullptr);
  EXPECT_EQ(stage.state()["positionRule"], "replace");
}

}  // namespace
}  // namespace marey::app
