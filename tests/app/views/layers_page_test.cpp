#include <gtest/gtest.h>

#include "core/editing/key_edits.h"
#include "tests/app/support/app_stage.h"

namespace marey::app {
namespace {

using Json = nlohmann::json;

/// The giant swing with its first joint selected; channel 3 is the Zrotation of the arms.
class LayersPageTest : public testing::Test {
 protected:
  static constexpr ChannelIndex kChannel = 3;

  void SetUp() override {
    stage_.open_sample("giant-swing");
    stage_.app().session().selection.select_only(0);
    stage_.app().session().playback.set_playing(false);
    stage_.app().run_command("view.layers", nullptr);
    stage_.settle();
    before_ = stage_.app().save_text();
  }

  [[nodiscard]] const Clip& clip() { return stage_.app().session().document.clip(); }
  [[nodiscard]] double sample(FrameIndex frame) { return clip().motion.sample(kChannel, frame); }
  [[nodiscard]] std::string text() { return stage_.app().save_text(); }

  void go_to(FrameIndex frame) {
    stage_.app().session().playback.set_position(frame);
    stage_.settle();
  }

  void click(const std::string& item) {
    stage_.click(item);
    stage_.settle();
  }

  ImVec2 place_of(FrameIndex frame) {
    const Json place = stage_.app().run_command("curve.locate", {{"channel", kChannel}, {"frame", frame}});
    return {place["x"].get<float>(), place["y"].get<float>()};
  }

  void drag(ImVec2 from, ImVec2 by) {
    ImGuiStage::move_mouse(from);
    stage_.settle();
    ImGuiStage::press_mouse(true);
    stage_.frame();
    for (int i = 1; i <= 4; ++i) {
      ImGuiStage::move_mouse({from.x + by.x * 0.25f * static_cast<float>(i), from.y + by.y * 0.25f * static_cast<float>(i)});
      stage_.frame();
    }
    ImGuiStage::press_mouse(false);
    stage_.settle();
  }

  AppStage stage_;
  std::string before_;
};

// A capture is corrected by a few keys without touching its samples.
TEST_F(LayersPageTest, NumbersSetKeysOnTheActiveLayer) {
  click("layer.add@layers");
  ASSERT_TRUE(stage_.shows("layers.row.0"));
  go_to(0);
  stage_.press(ImGuiKey_K);
  stage_.settle();
  go_to(22);
  stage_.press(ImGuiKey_K);
  stage_.settle();
  EXPECT_EQ(text(), before_) << "keys of the values that are there change nothing";
  go_to(11);
  click("inspector.tab.joint");
  stage_.double_click("inspector.channel.3");
  stage_.type("200");
  stage_.press(ImGuiKey_Enter);
  stage_.settle();
  EXPECT_NEAR(sample(11), 200.0, 1e-9);
  EXPECT_EQ(sample(0), clip().stack.beneath.at(kChannel)->at(0));
  EXPECT_EQ(find_keys(clip().stack, 0, kChannel)->keys.size(), 3u);
  EXPECT_NE(text(), before_);
  stage_.resize({1280.0f, 1200.0f, 1.0f});
  click("inspector.tab.layers");
  EXPECT_EQ(stage_.item("layers.key_count").label, "15 in 6 channels");
  click("layers.mute.0");
  EXPECT_EQ(text(), before_) << "a muted layer leaves the file byte for byte";
  click("layers.mute.0");
  EXPECT_NEAR(sample(11), 200.0, 1e-9);
  ASSERT_TRUE(stage_.shows("layers.deviation.3"));
  EXPECT_NE(stage_.item("layers.deviation.3").label.find("at 12"), std::string::npos) << stage_.item("layers.deviation.3").label;
}

TEST_F(LayersPageTest, ALockedLayerKeepsItsKeys) {
  click("layer.add@layers");
  click("layers.lock.0");
  EXPECT_TRUE(stage_.app().run_command("keys.set", nullptr).contains("error"));
  EXPECT_TRUE(clip().stack.layers[0].curves.empty());
  click("layers.lock.0");
  EXPECT_FALSE(stage_.app().run_command("keys.set", nullptr).contains("error"));
}

TEST_F(LayersPageTest, WeightScalesALayer) {
  click("layer.add@layers");
  go_to(5);
  stage_.app().run_command("keys.set", nullptr);
  click("inspector.tab.joint");
  stage_.double_click("inspector.channel.0");
  stage_.type("2");
  stage_.press(ImGuiKey_Enter);
  stage_.settle();
  const double original = clip().stack.beneath.at(0)->at(5);
  EXPECT_NEAR(clip().motion.sample(0, 5), 2.0, 1e-12);
  click("inspector.tab.layers");
  stage_.double_click("layers.weight");
  stage_.type("50");
  stage_.press(ImGuiKey_Enter);
  stage_.settle();
  EXPECT_NEAR(clip().motion.sample(0, 5), 0.5 * (original + 2.0), 1e-12);
}

TEST_F(LayersPageTest, TheRotationIsShownAsQuaternionAndVectorToo) {
  stage_.app().run_command("edit.operation", {{"do", "hold joints=Arms"}});
  stage_.app().run_command("edit.operation", {{"do", "scale joints=Arms channels=Zrotation factor=0 pivot=value value=60"}});
  stage_.resize({1280.0f, 1200.0f, 1.0f});
  click("inspector.tab.joint");
  EXPECT_EQ(stage_.item("inspector.quaternion").label, "0.866 0.000 0.000 0.500");
  EXPECT_EQ(stage_.item("inspector.rotation_vector").label, "0.00° 0.00° 60.00°");
}

TEST_F(LayersPageTest, TheWeightCanBeACurveAndLayersChangePlaces) {
  click("layer.add@layers");
  click("layer.add@layers");
  go_to(10);
  click("layers.weight_key");
  stage_.double_click("layers.weight");
  stage_.type("0");
  stage_.press(ImGuiKey_Enter);
  stage_.settle();
  const Layer& layer = clip().stack.layers[1];
  ASSERT_TRUE(layer.weight);
  EXPECT_EQ(KeyEvaluator(*layer.weight).value_at(0.0), 1.0);
  EXPECT_EQ(KeyEvaluator(*layer.weight).value_at(10.0), 0.0);
  EXPECT_FALSE(stage_.app().run_command("layer.down", nullptr).contains("error"));
  EXPECT_EQ(stage_.app().session().active_layer, 0);
  EXPECT_EQ(clip().stack.layers[0].name, "Layer 2");
  EXPECT_TRUE(stage_.app().run_command("layer.down", nullptr).contains("error"));
}

TEST_F(LayersPageTest, DeletingALayerAndUndoingFollowTheActiveOne) {
  click("layer.add@layers");
  click("layer.add@layers");
  EXPECT_EQ(stage_.app().session().active_layer, 1);
  click("layer.delete@layers");
  EXPECT_EQ(stage_.app().session().active_layer, 0);
  for (int i = 0; i < 3; ++i) stage_.app().run_command("edit.undo", nullptr);
  stage_.settle();
  EXPECT_EQ(stage_.app().session().active_layer, kOwnKeys);
  EXPECT_EQ(text(), before_);
}

TEST_F(LayersPageTest, KeysOfAChannelAreDraggedInTimeAndValue) {
  stage_.app().run_command("edit.operation", {{"do", "to-keys tolerance=2 interpolation=linear joints=Arms channels=Zrotation"}});
  stage_.settle();
  const SharedKeys keys = find_keys(clip().stack, kOwnKeys, kChannel);
  ASSERT_EQ(keys->keys.size(), 8u);
  const int depth = stage_.state()["undoDepth"];
  const auto frame = static_cast<FrameIndex>(keys->keys[3].frame);
  drag(place_of(frame), {0.0f, -24.0f});
  const SharedKeys moved = find_keys(clip().stack, kOwnKeys, kChannel);
  EXPECT_EQ(moved->keys[3].frame, frame);
  EXPECT_GT(moved->keys[3].value, keys->keys[3].value + 1.0);
  EXPECT_EQ(sample(frame), moved->keys[3].value);
  EXPECT_EQ(stage_.state()["undoDepth"], depth + 1) << "a drag is one step";
  stage_.app().run_command("edit.undo", nullptr);
  stage_.settle();
  EXPECT_EQ(find_keys(clip().stack, kOwnKeys, kChannel)->keys[3].value, keys->keys[3].value);
  const float one_frame = place_of(frame + 1).x - place_of(frame).x;
  drag(place_of(frame), {one_frame, 0.0f});
  EXPECT_EQ(find_keys(clip().stack, kOwnKeys, kChannel)->keys[3].frame, frame + 1.0);
}

TEST_F(LayersPageTest, AKeyOfALayerIsDraggedOnTheResult) {
  click("layer.add@layers");
  go_to(8);
  stage_.press(ImGuiKey_K);
  stage_.settle();
  const double value = sample(8);
  const ImVec2 place = place_of(8);
  drag(place, {0.0f, -30.0f});
  EXPECT_GT(sample(8), value + 1.0);
  EXPECT_NEAR(place_of(8).y, place.y - 30.0f, 0.6f) << "the result stays under the pointer";
}

TEST_F(LayersPageTest, HandlesArePulled) {
  stage_.app().run_command("edit.operation", {{"do", "to-keys tolerance=5 joints=Arms channels=Zrotation"}});
  const SharedKeys keys = find_keys(clip().stack, kOwnKeys, kChannel);
  ASSERT_GE(keys->keys.size(), 3u);
  const Key& key = keys->keys[1];
  go_to(static_cast<FrameIndex>(key.frame));
  const Handle handle = find_handles(*keys, 1).right;
  const ImVec2 at = place_of(static_cast<FrameIndex>(key.frame));
  const float frame_width = place_of(1).x - place_of(0).x;
  const ImVec2 up = place_of(0);
  const float per_value = (place_of(5).y - up.y) / static_cast<float>(sample(5) - sample(0));
  drag({at.x + static_cast<float>(handle.frames) * frame_width, at.y + static_cast<float>(handle.value) * per_value},
       {0.0f, -20.0f});
  const Key& pulled = find_keys(clip().stack, kOwnKeys, kChannel)->keys[1];
  EXPECT_EQ(pulled.value, key.value);
  EXPECT_GT(pulled.right.value / pulled.right.frames, handle.value / handle.frames + 0.1);
}

TEST_F(LayersPageTest, ALockedLayerStays) {
  click("layer.add@layers");
  click("layers.lock.0");
  const int depth = stage_.state()["undoDepth"].get<int>();
  click("layer.delete@layers");
  EXPECT_EQ(clip().stack.layers.size(), 1u);
  EXPECT_NE(stage_.state()["status"].get<std::string>().find("is locked"), std::string::npos) << stage_.state()["status"];
  stage_.wait(60.0);
  stage_.settle();
  EXPECT_EQ(stage_.state()["status"], "");
  stage_.drag("layers.weight", {-60.0f, 0.0f});
  stage_.settle();
  EXPECT_EQ(clip().stack.layers[0].weight, nullptr);
  EXPECT_EQ(stage_.state()["undoDepth"], depth);
  EXPECT_NE(stage_.state()["status"].get<std::string>().find("is locked"), std::string::npos) << stage_.state()["status"];
  const auto refused = stage_.app().run_command("layer.add", {{"mode", "sideways"}});
  EXPECT_TRUE(refused.contains("error"));
}

}  // namespace
}  // namespace marey::app
