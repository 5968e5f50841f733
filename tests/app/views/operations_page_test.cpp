#include <gtest/gtest.h>

#include "core/editing/operation.h"
#include "tests/app/support/app_stage.h"

namespace marey::app {
namespace {

class OperationsPageTest : public testing::Test {
 protected:
  void SetUp() override {
    stage_.open_sample("walk");
    stage_.app().session().selection.select_only(3);
    stage_.settle();
    before_ = stage_.app().save_text();
  }

  void open(const std::string& operation) {
    stage_.app().run_command("operation." + operation, nullptr);
    stage_.settle();
  }

  [[nodiscard]] std::string text() { return stage_.app().save_text(); }
  [[nodiscard]] int undo_depth() { return stage_.state()["undoDepth"].get<int>(); }

  static std::string two_hinges() {
    std::string clip =
        "HIERARCHY\nROOT Shoulder\n{\n  OFFSET 0 0 0\n  CHANNELS 1 Zrotation\n  JOINT Elbow\n  {\n    OFFSET 10 0 0\n"
        "    CHANNELS 1 Zrotation\n    End Site\n    {\n      OFFSET 10 0 0\n    }\n  }\n}\nMOTION\nFrames: 20\nFrame Time: 0.04\n";
    for (int frame = 0; frame < 20; ++frame) clip += std::to_string(frame) + ".00 10.00\n";
    return clip;
  }

  void try_every_form() {
    const JointIndex joint = stage_.app().session().selection.active_joint();
    for (const Operation& operation : operations()) {
      SCOPED_TRACE(operation.id);
      open(std::string(operation.id));
      ASSERT_TRUE(stage_.shows("operation.apply"));
      stage_.click("operation.apply");
      stage_.settle();
      if (stage_.shows("operation.cancel")) stage_.click("operation.cancel");
      stage_.settle();
      changed_ += undo_depth();
      while (undo_depth() > 0) stage_.app().run_command("edit.undo", nullptr);
      stage_.settle();
      ASSERT_EQ(text(), before_);
      stage_.app().session().selection.select_only(joint);
    }
  }

  AppStage stage_;
  std::string before_;
  int changed_ = 0;
};

TEST_F(OperationsPageTest, ShowsTheOutcomeBeforeItIsApplied) {
  open("smooth");
  EXPECT_NE(text(), before_);
  const std::string narrow = text();
  stage_.drag("operation.value.sigma", {60.0f, 0.0f});
  stage_.settle();
  EXPECT_NE(text(), narrow) << "the preview follows the value";
  EXPECT_EQ(undo_depth(), 1) << "and stays one step";
  stage_.click("operation.apply");
  stage_.settle();
  EXPECT_EQ(undo_depth(), 1);
  ASSERT_TRUE(stage_.shows("operation.report.0"));
  stage_.app().run_command("edit.undo", nullptr);
  EXPECT_EQ(text(), before_);
}

TEST_F(OperationsPageTest, CancelAndEscapeTakeItBack) {
  open("smooth");
  stage_.click("operation.cancel");
  stage_.settle();
  EXPECT_EQ(text(), before_);
  EXPECT_EQ(undo_depth(), 0);
  open("smooth");
  EXPECT_NE(text(), before_);
  stage_.press(ImGuiKey_Escape);
  stage_.settle();
  EXPECT_EQ(text(), before_);
}

TEST_F(OperationsPageTest, AnotherPageTakesThePreviewBack) {
  open("smooth");
  EXPECT_NE(text(), before_);
  stage_.click("inspector.tab.joint");
  stage_.settle();
  EXPECT_EQ(text(), before_);
}

TEST_F(OperationsPageTest, WithoutPreviewNothingHappensBeforeApply) {
  open("smooth");
  stage_.click("operation.preview");
  stage_.settle();
  EXPECT_EQ(text(), before_);
  stage_.click("operation.apply");
  stage_.settle();
  EXPECT_NE(text(), before_);
  EXPECT_EQ(undo_depth(), 1);
}

TEST_F(OperationsPageTest, WorksOnWhatIsSelected) {
  stage_.app().run_command("curve.select", {{"channel", 12}, {"first", 9}, {"count", 12}});
  open("offset");
  EXPECT_EQ(stage_.item("operation.described").label, "1 channel, frames 10 to 21");
  stage_.click("operation.target");
  stage_.settle();
  stage_.click("operation.target.clip");
  stage_.settle();
  EXPECT_EQ(stage_.item("operation.described").label, "66 channels, frames 1 to 192");
}

TEST_F(OperationsPageTest, UndoneMeansNoPreviewAnyMore) {
  open("smooth");
  stage_.app().run_command("edit.undo", nullptr);
  stage_.settle();
  EXPECT_EQ(text(), before_);
  EXPECT_EQ(undo_depth(), 0) << "it is not made again by itself";
}

TEST_F(OperationsPageTest, SaysWhyItIsRefused) {
  open("butterworth");
  stage_.double_click("operation.value.cutoff");
  stage_.type("500");
  stage_.press(ImGuiKey_Enter);
  stage_.settle();
  ASSERT_TRUE(stage_.shows("operation.refusal"));
  EXPECT_NE(stage_.item("operation.refusal").label.find("half the frame rate"), std::string::npos);
  EXPECT_EQ(text(), before_);
}

TEST_F(OperationsPageTest, FindsOperationsByName) {
  stage_.click("inspector.tab.edit");
  stage_.settle();
  EXPECT_TRUE(stage_.shows("operation.smooth"));
  stage_.click("operations.search");
  stage_.type("mirror");
  stage_.settle();
  EXPECT_FALSE(stage_.shows("operation.smooth"));
  stage_.click("operation.mirror");
  stage_.settle();
  EXPECT_TRUE(stage_.shows("operation.apply"));
}

// Each by its own form: opened, previewed, applied, undone.
TEST_F(OperationsPageTest, EveryOperationHasAForm) {
  try_every_form();
  EXPECT_GT(changed_, 20);
}

TEST_F(OperationsPageTest, EveryOperationHasAFormForAClipOfTwoHinges) {
  ASSERT_TRUE(stage_.open_text("arm.bvh", two_hinges()));
  stage_.app().session().selection.select_only(1);
  stage_.settle();
  before_ = text();
  try_every_form();
  EXPECT_GT(changed_, 5);
}

TEST_F(OperationsPageTest, TheFilterExplorerLooksAtTheCurve) {
  open("butterworth");
  stage_.app().run_command("view.filter_explorer", nullptr);
  stage_.settle();
  for (const char* plot : {"explorer.plot.0", "explorer.plot.1", "explorer.plot.2", "explorer.plot.3"}) {
    EXPECT_TRUE(stage_.shows(plot)) << plot;
  }
  EXPECT_NE(stage_.item("explorer.change").label.find("Grey is before"), std::string::npos);
  // While the value is dragged too, which is a gesture of its own.
  const UiItem field = stage_.item("operation.value.cutoff");
  ImGuiStage::move_mouse({field.min.x + 40.0f, 0.5f * (field.min.y + field.max.y)});
  stage_.settle();
  ImGuiStage::press_mouse(true);
  stage_.frame();
  for (int i = 1; i <= 6; ++i) {
    ImGuiStage::move_mouse({field.min.x + 40.0f - 3.0f * static_cast<float>(i), 0.5f * (field.min.y + field.max.y)});
    stage_.frame();
  }
  stage_.frame();
  EXPECT_NE(stage_.item("explorer.change").label.find("Grey is before"), std::string::npos);
  ImGuiStage::press_mouse(false);
  stage_.settle();
  stage_.app().run_command("view.rotation_orders", nullptr);
  stage_.settle();
  EXPECT_TRUE(stage_.shows("orders.plot.5"));
  EXPECT_FALSE(stage_.shows("explorer.plot.0"));
  EXPECT_NE(stage_.item("orders.plot.4").label.find("ZXY (as it is)"), std::string::npos);
  stage_.app().run_command("view.curve_editor", nullptr);
  stage_.settle();
  EXPECT_TRUE(stage_.shows("curves.canvas"));
}

TEST_F(OperationsPageTest, TakesAnotherClip) {
  open("append");
  EXPECT_FALSE(stage_.shows("operation.other"));
  stage_.click("operation.apply");
  stage_.settle();
  EXPECT_TRUE(stage_.shows("operation.apply"));
  EXPECT_EQ(stage_.item("operation.note").label, "Choose the other clip first.");
  stage_.click("operation.value.from");
  EXPECT_EQ(stage_.log().other_requests, 1);
  App& app = stage_.app();
  ASSERT_TRUE(app.begin_loading("again.bvh", 0, FileUse::OtherClip));
  ASSERT_TRUE(app.feed_loading(before_));
  ASSERT_TRUE(app.finish_loading());
  stage_.settle();
  EXPECT_EQ(stage_.item("operation.other").label, "again.bvh");
  EXPECT_EQ(stage_.state()["file"], "walk.bvh");
  EXPECT_EQ(stage_.state()["otherFile"], "again.bvh");
  const int frames = app.session().document.motion().frame_count();
  EXPECT_EQ(undo_depth(), 1);
  EXPECT_GT(frames, 300);
  stage_.click("operation.apply");
  stage_.settle();
  EXPECT_FALSE(stage_.shows("operation.apply"));
  app.run_command("edit.undo", nullptr);
  EXPECT_EQ(text(), before_);
  const nlohmann::json answer = app.run_command("edit.operation", {{"do", "append from=again.bvh"}});
  EXPECT_EQ(answer["changed"], true) << answer;
  EXPECT_EQ(app.session().document.motion().frame_count(), frames);
  EXPECT_TRUE(app.run_command("edit.operation", {{"do", "append from=no.bvh"}}).contains("error"));
}

TEST_F(OperationsPageTest, ABrokenOtherClipLeavesTheFormAsItIs) {
  open("splice");
  App& app = stage_.app();
  ASSERT_TRUE(app.begin_loading("bad.bvh", 0, FileUse::OtherClip));
  app.feed_loading("nothing\n");
  EXPECT_FALSE(app.finish_loading());
  stage_.settle();
  EXPECT_FALSE(stage_.shows("operation.other"));
  EXPECT_EQ(stage_.state()["messages"].size(), 1u);
  EXPECT_EQ(text(), before_);
}

// A long clip is made into keys channel by channel, with progress, and can be left in the middle.
TEST(LongOperation, ShowsProgressAndCanBeCancelled) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("long.bvh", small_bvh(30000)));
  stage.settle();
  const int channels = stage.state()["channels"];
  ASSERT_GT(channels * 30000, 200000);
  stage.app().session().selection.clear_joints();
  const auto open = [&] {
    stage.app().run_command("operation.to-keys", nullptr);
    stage.frame();
    stage.frame();
  };
  open();
  ASSERT_TRUE(stage.shows("operation.progress"));
  EXPECT_FALSE(stage.shows("operation.apply"));
  stage.press(ImGuiKey_Escape);
  stage.settle();
  EXPECT_EQ(stage.state()["keyedChannels"], 0);
  EXPECT_TRUE(stage.shows("operations.search"));
  open();
  EXPECT_GT(stage.settle(1000), 3) << "the page is drawn in between";
  EXPECT_EQ(stage.state()["keyedChannels"], channels);
  EXPECT_TRUE(stage.shows("operation.note"));
  stage.click("operation.apply");
  stage.settle();
  EXPECT_EQ(stage.state()["undoDepth"], 1);
  stage.app().run_command("edit.undo", nullptr);
  EXPECT_EQ(stage.state()["keyedChannels"], 0);
}

}  // namespace
}  // namespace marey::app
