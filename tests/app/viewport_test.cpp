#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "tests/app/support/app_stage.h"

namespace marey::app {
namespace {

using nlohmann::json;

/// The page with an upright figure of three bones, used in its viewport by mouse.
class Viewport : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(stage_.open_text("small.bvh", small_bvh(5)).ok());
    stage_.app().session().playback.set_playing(false);
    stage_.app().session().selection.clear_joints();
    stage_.settle();
  }

  [[nodiscard]] const Scene& scene() { return stage_.app().scene(); }
  [[nodiscard]] const Selection& selection() { return stage_.app().session().selection; }

  ImVec2 on_screen(const glm::vec3& world) {
    const glm::vec4 clip = scene().projection * scene().view * glm::vec4(world, 1.0f);
    return {scene().x + (0.5f + 0.5f * clip.x / clip.w) * scene().width,
            scene().y + (0.5f - 0.5f * clip.y / clip.w) * scene().height};
  }
  ImVec2 middle_of_bone(std::size_t bone) { return on_screen(0.5f * (scene().bones[bone].from + scene().bones[bone].to)); }
  /// A place in the view with nothing on it.
  ImVec2 empty_place() { return {scene().x + 0.15f * scene().width, scene().y + 0.5f * scene().height}; }

  void drag(ImGuiMouseButton button, ImVec2 from, ImVec2 by) {
    ImGuiStage::move_mouse(from);
    stage_.frame();
    ImGui::GetIO().AddMouseButtonEvent(button, true);
    stage_.frame();
    for (int step = 1; step <= 4; ++step) {
      const float share = static_cast<float>(step) / 4.0f;
      ImGuiStage::move_mouse({from.x + by.x * share, from.y + by.y * share});
      stage_.frame();
    }
    ImGui::GetIO().AddMouseButtonEvent(button, false);
    for (int i = 0; i < 3; ++i) stage_.frame();
  }

  void click_with(ImGuiKey modifier, ImVec2 place) {
    ImGui::GetIO().AddKeyEvent(modifier, true);
    stage_.click_at(place);
    ImGui::GetIO().AddKeyEvent(modifier, false);
    stage_.frame();
  }

  AppStage stage_;
};

TEST_F(Viewport, ShowsTheFigureWholeAndProminent) {
  ASSERT_EQ(scene().bones.size(), 3u);
  const ImVec2 foot = on_screen(scene().bones.front().from);
  const ImVec2 top = on_screen(scene().bones.back().to);
  EXPECT_LT(foot.y, scene().y + scene().height);
  EXPECT_GT(top.y, scene().y);
  EXPECT_GT(foot.y - top.y, 0.5f * scene().height);
}

TEST_F(Viewport, AClickSelectsTheJointThatTurnsTheBone) {
  stage_.click_at(middle_of_bone(1));
  EXPECT_EQ(selection().joints(), std::vector<JointIndex>{1});
  EXPECT_EQ(scene().outlined_bones.size(), 1u);
  stage_.click_at(middle_of_bone(2));
  EXPECT_EQ(selection().joints(), std::vector<JointIndex>{2});
}

TEST_F(Viewport, ShiftAndCtrlAddAndRemove) {
  stage_.click_at(middle_of_bone(0));
  click_with(ImGuiMod_Shift, middle_of_bone(2));
  EXPECT_EQ(selection().joints(), (std::vector<JointIndex>{0, 2}));
  click_with(ImGuiMod_Ctrl, middle_of_bone(0));
  EXPECT_EQ(selection().joints(), std::vector<JointIndex>{2});
  click_with(ImGuiMod_Shift, empty_place());
  EXPECT_EQ(selection().joints(), std::vector<JointIndex>{2}) << "a miss changes nothing";
}

TEST_F(Viewport, AClickOnNothingClears) {
  stage_.click_at(middle_of_bone(0));
  stage_.click_at(empty_place());
  EXPECT_TRUE(selection().joints().empty());
}

TEST_F(Viewport, HoverLightensTheBone) {
  const glm::vec4 before = scene().bones[1].color;
  ImGuiStage::move_mouse(middle_of_bone(1));
  for (int i = 0; i < 3; ++i) stage_.frame();
  EXPECT_GT(glm::length(glm::vec3(scene().bones[1].color)), glm::length(glm::vec3(before)));
}

TEST_F(Viewport, LeftDragOrbitsAndSelectsNothing) {
  const glm::vec3 eye = scene().eye;
  drag(ImGuiMouseButton_Left, middle_of_bone(1), {80.0f, 0.0f});
  EXPECT_TRUE(selection().joints().empty());
  EXPECT_GT(glm::distance(scene().eye, eye), 1.0f);
  EXPECT_NEAR(scene().eye.y, eye.y, 1e-3f);
}

TEST_F(Viewport, RightDragMovesTheSceneWithThePointer) {
  const ImVec2 before = middle_of_bone(1);
  drag(ImGuiMouseButton_Right, empty_place(), {60.0f, -20.0f});
  const ImVec2 after = middle_of_bone(1);
  EXPECT_NEAR(after.x - before.x, 60.0f, 4.0f);
  EXPECT_NEAR(after.y - before.y, -20.0f, 4.0f);
}

TEST_F(Viewport, TheWheelZoomsToThePointer) {
  const ImVec2 place = on_screen(scene().bones.back().to);
  const float height = on_screen(scene().bones.front().from).y - place.y;
  ImGuiStage::move_mouse(place);
  stage_.frame();
  ImGui::GetIO().AddMouseWheelEvent(0.0f, 3.0f);
  for (int i = 0; i < 3; ++i) stage_.frame();
  const ImVec2 zoomed = on_screen(scene().bones.back().to);
  EXPECT_GT(on_screen(scene().bones.front().from).y - zoomed.y, 1.3f * height);
  EXPECT_NEAR(zoomed.x, place.x, 6.0f);
  EXPECT_NEAR(zoomed.y, place.y, 6.0f);
}

TEST_F(Viewport, CommandsLookAlongAxesAndFrame) {
  stage_.app().run_command("view.side", nullptr);
  stage_.wait(1.0);
  stage_.settle();
  const glm::mat4 view_to_world = glm::inverse(scene().view);
  EXPECT_NEAR(view_to_world[2].x, 1.0f, 1e-4f);
  stage_.app().run_command("view.zoom_out", nullptr);
  stage_.app().run_command("view.frame_all", nullptr);
  stage_.wait(1.0);
  stage_.settle();
  EXPECT_GT(on_screen(scene().bones.front().from).y - on_screen(scene().bones.back().to).y, 0.5f * scene().height);
}

TEST_F(Viewport, ATransitionAsksForFramesAndEnds) {
  stage_.settle();
  stage_.app().run_command("view.top", nullptr);
  const int frames = stage_.settle();
  EXPECT_GT(frames, 4);
  EXPECT_LT(frames, 40);
  const glm::mat4 view_to_world = glm::inverse(scene().view);
  EXPECT_NEAR(view_to_world[2].y, 1.0f, 1e-4f);
}

TEST_F(Viewport, OrthographicIsASwitch) {
  EXPECT_FALSE(scene().orthographic);
  stage_.app().run_command("view.orthographic", {{"on", true}});
  stage_.wait(1.0);
  stage_.settle();
  EXPECT_TRUE(scene().orthographic);
  EXPECT_EQ(scene().projection[2][3], 0.0f);
}

TEST_F(Viewport, OrbitRefusesWrongArguments) {
  EXPECT_TRUE(stage_.app().run_command("view.orbit", {{"yaw", "left"}}).contains("error"));
  EXPECT_FALSE(stage_.app().run_command("view.orbit", {{"yaw", 30}, {"pitch", 10}}).contains("error"));
}

TEST_F(Viewport, StrobeDrawsFadedPosesOnce) {
  EXPECT_TRUE(scene().faded_bones.empty());
  stage_.app().run_command("view.strobe", {{"on", true}});
  stage_.settle();
  EXPECT_EQ(scene().faded_bones.size(), 5u * 3u) << "every frame of so short a clip";
  const std::uint64_t revision = scene().faded_revision;
  stage_.frame();
  EXPECT_EQ(scene().faded_revision, revision);
  for (const SceneBone& bone : scene().faded_bones) EXPECT_LT(bone.color.a, 0.6f);
}

TEST_F(Viewport, TrailsGoThroughTheShownPose) {
  stage_.app().run_command("view.trails", {{"on", true}});
  stage_.app().session().playback.set_position(2.0);
  stage_.settle();
  ASSERT_FALSE(scene().lines.empty());
  EXPECT_EQ(scene().lines[0].count, 5);
  EXPECT_LT(glm::distance(scene().line_points[2].position, scene().bones.back().to), 1e-4f);
}

TEST_F(Viewport, TheBodyFollowsAnEdit) {
  const glm::vec3 before = scene().bones.back().to;
  Session& session = stage_.app().session();
  session.selection.change_samples().add(3, {0, 5});
  const json result = stage_.app().run_command("curve.move", {{"delta", 40.0}});
  ASSERT_FALSE(result.contains("error")) << result;
  stage_.settle();
  EXPECT_GT(glm::distance(scene().bones.back().to, before), 1.0f);
}

TEST_F(Viewport, TheGizmoTurnsTheView) {
  stage_.click("viewport.gizmo.x");
  stage_.settle();
  EXPECT_NEAR(glm::inverse(scene().view)[2].x, 1.0f, 1e-4f);
  stage_.click("viewport.gizmo.x");
  stage_.settle();
  EXPECT_NEAR(glm::inverse(scene().view)[2].x, -1.0f, 1e-4f) << "again: from the other side";
}

TEST_F(Viewport, AtRestDrawsNoFrames) { EXPECT_LE(stage_.settle(), 3); }

TEST(ViewportWithoutAFile, DrawsAnEmptyStage) {
  AppStage stage;
  EXPECT_TRUE(stage.app().scene().bones.empty());
  EXPECT_GT(stage.app().scene().width, 0.0f);
}

}  // namespace
}  // namespace marey::app
