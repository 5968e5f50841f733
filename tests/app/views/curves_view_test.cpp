#include "wasm/views/curves_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/support/app_stage.h"

namespace marey::app {
namespace {

using Json = nlohmann::json;

/// The giant swing with its first joint selected; channel 3 is the Zrotation of the arms.
class CurvesViewTest : public testing::Test {
 protected:
  static constexpr int kChannel = 3;

  void SetUp() override {
    stage_.open_sample("giant-swing");
    stage_.app().session().selection.select_only(0);
    stage_.settle();
  }

  const Motion& motion() { return stage_.app().session().document.motion(); }

  ImVec2 place_of(int frame) {
    const Json place = stage_.app().run_command("curve.locate", {{"channel", kChannel}, {"frame", frame}});
    return {place["x"].get<float>(), place["y"].get<float>()};
  }

  void drag_sample(int frame, float up, int steps = 4) {
    const ImVec2 start = place_of(frame);
    ImGuiStage::move_mouse(start);
    stage_.settle();
    ImGuiStage::press_mouse(true);
    stage_.frame();
    for (int i = 1; i <= steps; ++i) {
      ImGuiStage::move_mouse({start.x, start.y - up * static_cast<float>(i) / static_cast<float>(steps)});
      stage_.frame();
    }
  }

  void release() {
    ImGuiStage::press_mouse(false);
    stage_.settle();
  }

  AppStage stage_;
};

TEST_F(CurvesViewTest, ADragMovesASampleAndUndoBringsItBack) {
  stage_.app().run_command("curve.falloff", {{"radius", 0}});
  const double before = motion().sample(kChannel, 11);
  drag_sample(11, 20.0f);
  EXPECT_GT(motion().sample(kChannel, 11), before) << "the body follows while the button is down";
  release();
  EXPECT_EQ(stage_.state()["undoDepth"], 1);
  EXPECT_EQ(motion().sample(kChannel, 10), 186.3) << "without falloff the neighbours stay";
  stage_.app().run_command("edit.undo", nullptr);
  EXPECT_EQ(motion().sample(kChannel, 11), before);
}

TEST_F(CurvesViewTest, ADragOverBeforeTheNextFrameStillCounts) {
  const double before = motion().sample(kChannel, 11);
  const ImVec2 start = place_of(11);
  ImGuiStage::move_mouse(start);
  ImGuiStage::press_mouse(true);
  ImGuiStage::move_mouse({start.x, start.y - 20.0f});
  release();
  EXPECT_EQ(stage_.state()["undoDepth"], 1);
  EXPECT_GT(motion().sample(kChannel, 11), before);
}

TEST_F(CurvesViewTest, AScrubOverBeforeTheNextFrameArrives) {
  const UiItem& ruler = stage_.item("timeline.ruler");
  const float y = ruler.min.y + 6.0f;
  const float right = ruler.max.x;
  ImGuiStage::move_mouse({ruler.min.x + 20.0f, y});
  ImGuiStage::press_mouse(true);
  ImGuiStage::move_mouse({right, y});
  release();
  EXPECT_EQ(stage_.state()["frame"], 22);
}

TEST_F(CurvesViewTest, FalloffTakesNeighboursAlongByTheirShare) {
  stage_.app().run_command("curve.falloff", {{"radius", 4}});
  const double before[] = {motion().sample(kChannel, 11), motion().sample(kChannel, 13), motion().sample(kChannel, 15)};
  drag_sample(11, 30.0f);
  release();
  const double moved = motion().sample(kChannel, 11) - before[0];
  const double neighbour = motion().sample(kChannel, 13) - before[1];
  EXPECT_GT(moved, 1.0);
  EXPECT_NEAR(neighbour, 0.5 * moved, 1e-9) << "half way out a raised cosine is one half";
  EXPECT_EQ(motion().sample(kChannel, 15), before[2]);
}

TEST_F(CurvesViewTest, EscapeTakesADragBack) {
  const double before = motion().sample(kChannel, 11);
  drag_sample(11, 25.0f);
  ASSERT_NE(motion().sample(kChannel, 11), before);
  stage_.press(ImGuiKey_Escape);
  release();
  EXPECT_EQ(motion().sample(kChannel, 11), before);
  EXPECT_EQ(stage_.state()["undoDepth"], 0);
  EXPECT_FALSE(stage_.state()["dirty"].get<bool>());
}

TEST_F(CurvesViewTest, AClickSelectsOneSampleAndABoxSelectsMany) {
  stage_.click_at(place_of(5));
  EXPECT_EQ(stage_.app().session().selection.samples().count(), 1);
  EXPECT_TRUE(stage_.app().session().selection.samples().contains(kChannel, 5));
  const UiItem canvas = stage_.item("curves.canvas");
  ImGuiStage::move_mouse({canvas.min.x + 2.0f, canvas.min.y + 2.0f});
  stage_.settle();
  ImGuiStage::press_mouse(true);
  stage_.frame();
  ImGuiStage::move_mouse({canvas.max.x - 2.0f, canvas.max.y - 2.0f});
  stage_.frame();
  stage_.frame();
  release();
  EXPECT_GE(stage_.app().session().selection.samples().count(), 23 * 6);
}

TEST_F(CurvesViewTest, ATypedValueGoesToTheSelectedSample) {
  stage_.click_at(place_of(5));
  stage_.double_click("curves.value");
  stage_.press(ImGuiMod_Ctrl | ImGuiKey_A);
  stage_.type("90.5");
  stage_.press(ImGuiKey_Enter);
  EXPECT_EQ(motion().sample(kChannel, 5), 90.5);
  EXPECT_EQ(stage_.state()["undoDepth"], 1);
}

TEST_F(CurvesViewTest, AClickInTheChannelListHidesACurve) {
  stage_.click("curves.channel.3");
  EXPECT_FALSE(stage_.app().session().selection.is_channel_visible(3));
  stage_.click("curves.channel.3");
  EXPECT_TRUE(stage_.app().session().selection.is_channel_visible(3));
}

TEST_F(CurvesViewTest, CommandsRefuseWhatCannotBe) {
  const auto error_of = [&](const char* id, const Json& args) {
    const Json answer = stage_.app().run_command(id, args);
    return answer.is_object() && answer.contains("error");
  };
  EXPECT_TRUE(error_of("curve.smooth", nullptr)) << "nothing is selected";
  stage_.app().run_command("curve.select_all", nullptr);
  EXPECT_TRUE(error_of("curve.smooth", {{"sigma", -1}}));
  EXPECT_TRUE(error_of("curve.smooth", {{"sigma", "wide"}}));
  EXPECT_TRUE(error_of("curve.select", {{"channel", 12}}));
  EXPECT_TRUE(error_of("curve.set_value", Json::object()));
  EXPECT_EQ(stage_.state()["undoDepth"], 0);
  EXPECT_FALSE(error_of("curve.smooth", {{"sigma", 1.5}}));
  EXPECT_EQ(stage_.state()["undoDepth"], 1);
}

TEST_F(CurvesViewTest, FitSelectionZoomsToTheSamples) {
  stage_.app().run_command("curve.select", {{"channel", kChannel}, {"first", 8}, {"count", 3}});
  stage_.app().run_command("curve.fit_selection", nullptr);
  stage_.settle();
  const UiItem canvas = stage_.item("curves.canvas");
  EXPECT_LT(place_of(8).x - canvas.min.x, 0.3f * (canvas.max.x - canvas.min.x));
  EXPECT_GT(place_of(10).x - canvas.min.x, 0.7f * (canvas.max.x - canvas.min.x));
}

}  // namespace
}  // namespace marey::app
