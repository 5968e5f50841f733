#include "wasm/app/performance.h"

#include <gtest/gtest.h>

#include "tests/app/support/app_stage.h"

namespace marey::app {
namespace {

FrameCost cost_of(double ms) { return {.cpu_ms = ms, .draw_calls = 3, .vertices = 100}; }

TEST(Performance, GivesMedianAndWorstOfTheFramesItKeeps) {
  Performance performance;
  EXPECT_EQ(performance.median_ms(), 0.0f);
  for (const double ms : {5.0, 1.0, 3.0}) performance.add_frame(cost_of(ms), 0.0, false);
  EXPECT_EQ(performance.median_ms(), 3.0f);
  EXPECT_EQ(performance.worst_ms(), 5.0f);
  EXPECT_EQ(performance.cpu_ms(0), 5.0f);
  EXPECT_EQ(performance.cpu_ms(2), 3.0f);
  for (int i = 0; i < Performance::kFramesKept; ++i) performance.add_frame(cost_of(2.0), 0.0, false);
  EXPECT_EQ(performance.worst_ms(), 2.0f) << "older ones are forgotten";
  EXPECT_EQ(performance.frame_count(), Performance::kFramesKept);
}

TEST(Performance, CountsFramesWhilePlayingAndKeepsTheRate) {
  Performance performance;
  double now_s = 5.0;
  for (int i = 0; i < 60; ++i) performance.add_frame(cost_of(1.0), now_s += 1.0 / 30.0, true);
  EXPECT_NEAR(performance.frames_per_second(), 30.0, 0.5);
  for (int i = 0; i < 60; ++i) performance.add_frame(cost_of(1.0), now_s += 1.0, false);
  EXPECT_NEAR(performance.frames_per_second(), 30.0, 0.5);
  for (int i = 0; i < 60; ++i) performance.add_frame(cost_of(1.0), now_s += 1.0 / 60.0, true);
  EXPECT_NEAR(performance.frames_per_second(), 60.0, 0.5);
}

TEST(PerformanceCard, StandsInTheViewportAndIsInTheState) {
  AppStage stage;
  stage.open_sample("walk");
  EXPECT_FALSE(stage.shows("viewport.performance"));
  EXPECT_TRUE(stage.state()["performance"].is_null());
  stage.log().memory = {.used = 1000, .total = 5000};
  stage.press(ImGuiMod_Shift | ImGuiKey_T);
  stage.app().note_cost(cost_of(4.0));
  stage.frame();
  const UiItem& card = stage.item("viewport.performance");
  const UiItem& viewport = stage.item("viewport.canvas");
  EXPECT_GE(card.min.x, viewport.min.x);
  EXPECT_LE(card.max.y, viewport.max.y);
  const auto state = stage.state()["performance"];
  EXPECT_EQ(state["frameMs"], 4.0);
  EXPECT_EQ(state["drawCalls"], 3);
  EXPECT_EQ(state["memoryUsed"], 1000);
  EXPECT_GT(state["sampleBytes"], 10000);
}

TEST(PerformanceCard, LetsThePageRestAndThePointerThrough) {
  AppStage stage;
  stage.open_sample("walk");
  stage.press(ImGuiMod_Shift | ImGuiKey_T);
  stage.wait(10.0);
  EXPECT_LT(stage.settle(), 100);
  const float yaw_before = stage.app().scene().eye.x;
  stage.drag("viewport.performance", {60.0f, 0.0f});
  stage.settle();
  EXPECT_NE(stage.app().scene().eye.x, yaw_before) << "the drag turns the figure";
}

TEST(Idle, ThePageRestsWhateverThePointerIsOver) {
  AppStage stage;
  stage.open_sample("walk");
  stage.press(ImGuiMod_Shift | ImGuiKey_T);
  for (const char* id : {"play.toggle", "curves.canvas", "viewport.canvas", "timeline.ruler", "outliner.joint.0", "file.save"}) {
    stage.hover(id);
    for (int i = 0; i < 120; ++i) stage.frame();  // until the tool tip is there
    EXPECT_LE(stage.settle(), 3) << id;
  }
}

TEST(PerformanceCard, IsLeftOutWhereItHasNoRoom) {
  AppStage stage({.css_width = 200.0f, .css_height = 300.0f, .device_pixel_ratio = 1.0f});
  stage.open_sample("walk");
  stage.press(ImGuiMod_Shift | ImGuiKey_T);
  EXPECT_FALSE(stage.shows("viewport.performance"));
}

}  // namespace
}  // namespace marey::app
