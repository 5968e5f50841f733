#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/biomechanics/analysis.h"
#include "core/biomechanics/body_motion.h"
#include "core/biomechanics/chosen_body.h"
#include "core/biomechanics/segment_solid.h"
#include "core/editing/clip_operations.h"
#include "tests/app/support/allocation_count.h"
#include "tests/app/support/app_stage.h"
#include "wasm/app/analysis.h"

namespace marey::app {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

/// The giant swing in the analysis layout, its first segment selected.
class PlotsViewTest : public testing::Test {
 protected:
  void SetUp() override {
    stage_.open_sample("giant-swing");
    stage_.app().session().playback.set_playing(false);
    stage_.app().session().selection.select_only(1);
    stage_.app().run_command("analysis.layout", nullptr);
    stage_.settle();
  }

  [[nodiscard]] Json plots() { return stage_.state()["analysis"]["plots"]; }
  [[nodiscard]] const Clip& clip() { return stage_.app().session().document.clip(); }

  AppStage stage_;
};

TEST_F(PlotsViewTest, ShowsAngleVelocityAccelerationAndTorqueOfTheSelectedJoint) {
  ASSERT_EQ(plots().size(), 4u);
  const char* units[] = {"°", "°/s", "°/s²", "N·m"};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(plots()[i]["unit"], units[i]);
    EXPECT_EQ(plots()[i]["owner"], clip().skeleton.name(1));
    EXPECT_TRUE(stage_.shows("plots.canvas." + std::to_string(i)));
  }
  stage_.app().session().selection.select_only(2);
  stage_.settle();
  EXPECT_EQ(plots()[3]["owner"], clip().skeleton.name(2));
}

TEST_F(PlotsViewTest, HasTheNumbersOfTheAnalysisAtTheCursor) {
  const auto body = find_chosen_body(clip());
  AnalysisRequest request;
  request.quantities = {"torque:" + std::string(clip().skeleton.name(1))};
  request.model = body->body.model;
  const auto table = analyse(clip(), request);
  stage_.app().session().playback.set_position(7);
  stage_.settle();
  EXPECT_DOUBLE_EQ(plots()[3]["values"]["z"].get<double>(), table->columns[2].values[7]);
  stage_.app().session().playback.set_position(0);
  stage_.settle();
  EXPECT_TRUE(plots()[3]["values"]["z"].is_null());
}

TEST_F(PlotsViewTest, FollowsEditsAndTheirUndoing) {
  stage_.app().session().playback.set_position(7);
  stage_.settle();
  const Json before = plots();
  stage_.app().run_command("edit.operation", {{"do", "scale factor=2"}});
  stage_.settle();
  EXPECT_NE(plots(), before);
  stage_.app().run_command("edit.undo", nullptr);
  stage_.settle();
  EXPECT_EQ(plots(), before);
}

TEST_F(PlotsViewTest, PutsTheCursorWhereItIsDragged) {
  const UiItem canvas = stage_.item("plots.canvas.1");
  stage_.click_at({0.5f * (canvas.min.x + canvas.max.x), canvas.min.y + 10.0f});
  stage_.settle();
  EXPECT_NEAR(stage_.state()["frame"].get<int>(), 11, 1);
}

TEST_F(PlotsViewTest, AddsKeepsAndRemovesPlots) {
  stage_.click("plots.add");
  stage_.settle();
  stage_.click("plots.add.com");
  stage_.settle();
  ASSERT_EQ(plots().size(), 5u);
  EXPECT_EQ(plots()[4]["quantity"], "com");
  EXPECT_EQ(plots()[4]["owner"], "whole body");
  stage_.click("plots.pin.0");
  stage_.settle();
  stage_.app().session().selection.select_only(2);
  stage_.settle();
  EXPECT_EQ(plots()[0]["owner"], clip().skeleton.name(1));
  EXPECT_EQ(plots()[1]["owner"], clip().skeleton.name(2));
  for (int i = 0; i < 5; ++i) {
    stage_.click("plots.remove.0");
    stage_.settle();
  }
  EXPECT_TRUE(plots().empty());
  EXPECT_FALSE(stage_.shows("plots.canvas.0"));
}

TEST_F(PlotsViewTest, IsSeenFromAnotherFrame) {
  stage_.app().run_command("play.go_to_frame", {{"frame", 7}});
  stage_.settle();
  const double usual = plots()[0]["values"]["z"].get<double>();
  stage_.click("plots.frame.of.0");
  stage_.settle();
  stage_.click("plots.frame.world");
  stage_.settle();
  EXPECT_EQ(plots()[0]["frame"], "world");
  const Motion& motion = clip().motion;
  EXPECT_NEAR(usual, motion.channel_samples(clip().skeleton.first_channel(1))[7], 1e-9);
  const double arms = motion.channel_samples(3)[7];
  EXPECT_NEAR(plots()[0]["values"]["z"].get<double>(), usual + arms, 1e-6);
  EXPECT_EQ(plots()[1]["frame"], "");
  stage_.app().run_command("analysis.plots", {{"quantities", {"position:Body+0/0.1/0@Arms", "angle@world", "torque"}}});
  stage_.settle();
  EXPECT_EQ(plots()[0]["owner"], "Body");
  EXPECT_EQ(plots()[0]["frame"], "Arms");
  EXPECT_FALSE(plots()[0]["values"].empty());
  EXPECT_EQ(plots()[1]["frame"], "world");
}

// What is dragged is followed at once, also in a clip that takes long; the rest comes with the end of the drag.
TEST_F(PlotsViewTest, FollowsADragInALongClip) {
  ASSERT_TRUE(stage_.open_text("long.bvh", small_bvh(8000)));
  stage_.settle();
  Session& session = stage_.app().session();
  Analysis dragged;
  EXPECT_FALSE(dragged.follow(session, 1, true, {}, false));
  stage_.app().run_command("edit.operation", {{"do", "scale factor=3 frames=4000:4010"}});
  const std::uint64_t serial = dragged.serial();
  EXPECT_TRUE(dragged.follow(session, 1, true, {}, true));
  EXPECT_GT(dragged.serial(), serial);
  Analysis whole;
  whole.follow(session, 1, true, {}, false);
  ASSERT_EQ(dragged.plots().size(), whole.plots().size());
  for (std::size_t i = 0; i < whole.plots().size(); ++i) {
    ASSERT_EQ(dragged.plots()[i].lines.size(), whole.plots()[i].lines.size());
    for (std::size_t line = 0; line < whole.plots()[i].lines.size(); ++line) {
      const auto& found = dragged.plots()[i].lines[line].values;
      const auto& expected = whole.plots()[i].lines[line].values;
      for (std::size_t f = 1; f + 1 < expected.size(); ++f) ASSERT_NEAR(found[f], expected[f], 1e-6 * std::abs(expected[f]) + 1e-6) << i << ", frame " << f;
    }
  }
  EXPECT_FALSE(dragged.follow(session, 1, true, {}, false));
}

TEST_F(PlotsViewTest, SaysWhereAJointIsMissing) {
  stage_.app().run_command("analysis.plots", {{"quantities", {"torque:Nobody", "angle"}}});
  stage_.settle();
  EXPECT_EQ(plots()[0]["values"], Json::object());
  EXPECT_FALSE(plots()[1]["values"].empty());
  EXPECT_TRUE(stage_.state()["analysis"]["problem"].is_null());
  EXPECT_TRUE(stage_.app().run_command("analysis.plots", {{"quantities", {"beauty"}}}).contains("error"));
}

TEST_F(PlotsViewTest, ShowsTheOtherTwoPages) {
  for (const char* mode : {"plots.mode.statistics", "plots.mode.against"}) {
    stage_.click("plots.mode");
    stage_.settle();
    stage_.click(mode);
    stage_.settle();
    EXPECT_TRUE(stage_.shows(std::string(mode) == "plots.mode.against" ? "plots.against.1" : "plots.statistics"));
  }
}

TEST_F(PlotsViewTest, WritesTableAndDrawing) {
  stage_.app().run_command("analysis.method", {{"derivative", "savgol:7,3"}, {"support", "pivot"}});
  stage_.settle();
  const Json csv = stage_.app().run_command("analysis.save_csv", nullptr);
  const auto& [name, text] = stage_.log().downloads.back();
  EXPECT_EQ(name, "giant-swing-plots.csv");
  EXPECT_EQ(csv["bytes"], text.size());
  for (const char* part : {"# file: giant-swing.bvh\n", "# sha256: ", "# derivative: savgol:7,3\n", "# support: pivot\n", "# body: ",
                           "frame,time[s],angle:", "[N.m]"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
  stage_.app().run_command("analysis.save_svg", nullptr);
  const std::string& svg = stage_.log().downloads.back().second;
  for (const char* part : {"width=\"180mm\"", "Joint torque [N·m]", "time [s]", "savgol:7,3", "</svg>"}) EXPECT_THAT(svg, HasSubstr(part));
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST_F(PlotsViewTest, DrawsBandsOfDoubtAroundTheCurves) {
  stage_.app().run_command("play.go_to_frame", {{"frame", 10}});
  stage_.settle();
  EXPECT_TRUE(plots()[3]["bands"].empty());
  for (const char* method : {"central", "butterworth:6", "savgol:7,3", "gcv"}) {
    stage_.app().run_command("analysis.method", {{"derivative", method}, {"bands", true}});
    stage_.settle();
    for (const std::size_t plot : {std::size_t{1}, std::size_t{2}, std::size_t{3}}) {
      const double value = plots()[plot]["values"]["z"];
      EXPECT_LE(plots()[plot]["bands"]["z"][0].get<double>(), value);
      EXPECT_GE(plots()[plot]["bands"]["z"][1].get<double>(), value);
    }
    // A unit of length 2 % larger alone makes torques of the same masses 4 % larger.
    const Json torque = plots()[3]["bands"]["z"];
    EXPECT_GT(torque[1].get<double>() - torque[0].get<double>(), 0.03 * std::abs(plots()[3]["values"]["z"].get<double>()));
  }
}

TEST_F(PlotsViewTest, SaysWhatSpeaksAgainstTheFrameTime) {
  stage_.app().run_command("view.curves", {{"on", false}});
  stage_.app().run_command("analysis.body", nullptr);
  stage_.settle();
  bool found = false;
  for (const UiItem& item : stage_.app().items().list()) found = found || item.label.find("the frame time may be wrong") != std::string::npos;
  EXPECT_TRUE(found);
}

TEST_F(PlotsViewTest, SuggestsACutoffByTheResiduals) {
  stage_.app().run_command("view.curves", {{"on", false}});
  stage_.app().run_command("analysis.body", nullptr);
  stage_.app().run_command("analysis.method", {{"derivative", "butterworth:99"}});
  stage_.settle();
  stage_.click("body.cutoff.suggest");
  stage_.settle();
  EXPECT_NE(stage_.state()["analysis"]["derivative"], "butterworth:99");
}

TEST_F(PlotsViewTest, DownloadsWhatIsOpenNow) {
  stage_.app().run_command("view.curve_editor", nullptr);
  stage_.settle();
  stage_.open_sample("walk");
  stage_.app().session().playback.set_playing(false);
  stage_.settle();
  stage_.app().run_command("analysis.save_csv", nullptr);
  const std::string& table = stage_.log().downloads.back().second;
  EXPECT_THAT(table, HasSubstr("# file: walk.bvh\n"));
  EXPECT_THAT(table, HasSubstr("\n192,3.18"));
  stage_.app().run_command("analysis.plots", {{"quantities", {"angle"}}});
  stage_.app().run_command("analysis.save_csv", nullptr);
  EXPECT_EQ(stage_.log().downloads.back().second.find("# body"), std::string::npos);
}

TEST_F(PlotsViewTest, ArrowsDoNotDoubleColumns) {
  stage_.app().run_command("view.arrows.torque", nullptr);
  stage_.settle();
  stage_.app().run_command("analysis.save_csv", nullptr);
  const std::string& table = stage_.log().downloads.back().second;
  const std::string name = "torque:" + std::string(clip().skeleton.name(1)) + ".z[N.m]";
  ASSERT_NE(table.find(name), std::string::npos);
  EXPECT_EQ(table.find(name, table.find(name) + 1), std::string::npos);
}

TEST_F(PlotsViewTest, GoOnWithoutABodyForWhatNeedsNone) {
  BodyChoice choice;
  choice.table = BodyTable::DeLevaFemale;
  AppStage stage;
  ASSERT_TRUE(stage.open_text("crane.bvh", small_bvh(9)));
  stage.app().run_command("analysis.layout", nullptr);
  ASSERT_TRUE(stage.app().session().apply(make_body_edit(stage.app().session().document.clip(), choice)));
  stage.app().session().playback.set_position(4);
  stage.settle();
  const Json plots = stage.state()["analysis"]["plots"];
  EXPECT_TRUE(stage.state()["analysis"]["problem"].is_null());
  EXPECT_FALSE(plots[0]["values"].empty());
  EXPECT_TRUE(plots[3]["values"].empty());
  EXPECT_TRUE(stage.shows("plots.remove.3"));
}

TEST_F(PlotsViewTest, MassesAreEditsOfTheBody) {
  stage_.app().run_command("view.curves", {{"on", false}});
  stage_.app().run_command("analysis.body", nullptr);
  stage_.settle();
  ASSERT_TRUE(stage_.shows("body.mass"));
  stage_.double_click("body.mass");
  stage_.settle();
  stage_.press(ImGuiMod_Ctrl | ImGuiKey_A);
  stage_.type("90");
  stage_.press(ImGuiKey_Enter);
  stage_.settle();
  EXPECT_EQ(clip().body.mass_kg, 90.0);
  EXPECT_EQ(stage_.state()["undoName"], "Change mass of the body");
  stage_.app().run_command("edit.undo", nullptr);
  EXPECT_EQ(clip().body, BodyChoice{});
}

TEST_F(PlotsViewTest, WhatAJointCarriesIsAnEditOfTheBody) {
  stage_.app().run_command("view.curves", {{"on", false}});
  stage_.app().run_command("analysis.body", nullptr);
  stage_.settle();
  const auto head_on = [&](JointIndex joint) {
    const auto body = find_chosen_body(clip());
    return std::any_of(body->body.parts.begin(), body->body.parts.end(),
                       [&](const GuessedPart& part) { return part.joint == joint && part.name == "head"; });
  };
  ASSERT_FALSE(head_on(2));
  stage_.app().session().selection.select_only(2);
  stage_.settle();
  stage_.click("body.carries");
  stage_.settle();
  stage_.click("body.carries.2");
  stage_.settle();
  ASSERT_EQ(clip().body.parts.size(), 1u);
  EXPECT_EQ(clip().body.parts[0], (OwnPart{2, BodyPart::Head}));
  EXPECT_TRUE(head_on(2));
  stage_.app().run_command("edit.undo", nullptr);
  stage_.settle();
  EXPECT_TRUE(clip().body.parts.empty());
  EXPECT_FALSE(head_on(2));
}

TEST_F(PlotsViewTest, DrawsArrowsAndTheCentreOfMass) {
  const std::size_t balls = stage_.app().scene().balls.size();
  const std::size_t lines = stage_.app().scene().lines.size();
  stage_.app().session().playback.set_position(10);
  for (const char* command : {"view.com", "view.arrows.force", "view.arrows.reaction"}) stage_.app().run_command(command, nullptr);
  stage_.settle();
  EXPECT_EQ(stage_.app().scene().balls.size(), balls + 1);
  EXPECT_GT(stage_.app().scene().lines.size(), lines + 5);
  EXPECT_TRUE(stage_.shows("viewport.arrows.2"));
  EXPECT_TRUE(stage_.shows("viewport.arrows.5"));
}

TEST_F(PlotsViewTest, DrawsSegmentsAsSolidsOfTheirInertia) {
  EXPECT_TRUE(stage_.app().scene().ellipsoids.empty());
  stage_.app().run_command("view.solids", nullptr);
  stage_.app().session().playback.set_position(10);
  stage_.settle();
  const std::vector<SceneEllipsoid> drawn = stage_.app().scene().ellipsoids;
  const auto body = find_chosen_body(clip());
  const std::vector<Segment>& segments = body->body.model.segments;
  ASSERT_EQ(drawn.size(), segments.size());
  const Result<BodyMotion> motion = find_body_motion(clip(), {}, clip().motion.frame_time_s(), clip().settings.metres_per_unit);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const glm::dvec3 center = state_of_point(motion->state(10, segments[i].joint), segments[i].com_m).position / clip().settings.metres_per_unit;
    EXPECT_LT(glm::distance(glm::dvec3(drawn[i].center), center), 1e-3 * glm::length(center)) << i;
    const glm::dvec3 half_axes = find_segment_solid(segments[i]).half_axes_m / clip().settings.metres_per_unit;
    for (int k = 0; k < 3; ++k) {
      // What is too thin is drawn thick enough to be seen.
      const double drawn_half = static_cast<double>(glm::length(drawn[i].axes[k]));
      EXPECT_TRUE(drawn_half > half_axes[k] - 1e-5 * drawn_half) << i << k;
      EXPECT_TRUE(drawn_half < half_axes[k] + 1e-5 * drawn_half || drawn_half < 1.0) << i << k;
    }
  }
  stage_.app().session().playback.set_position(11);
  stage_.settle();
  EXPECT_NE(stage_.app().scene().ellipsoids[0].center, drawn[0].center);
  stage_.app().run_command("view.solids", {{"on", false}});
  stage_.settle();
  EXPECT_TRUE(stage_.app().scene().ellipsoids.empty());
}

TEST(Plots, AllocateNothingWhilePlaying) {
  AppStage stage;
  stage.open_sample("walk");
  for (const char* command : {"analysis.layout", "view.com", "view.solids", "view.arrows.velocity", "view.arrows.force"}) stage.app().run_command(command, nullptr);
  stage.wait(10.0);
  stage.settle();
  stage.app().run_command("play.toggle", nullptr);
  for (int i = 0; i < 240; ++i) stage.frame();
  const AllocationCount count;
  for (int i = 0; i < 240; ++i) stage.frame();
  EXPECT_EQ(count.blocks(), 0u);
}

TEST(Plots, OfClipsWithFewFramesSayWhatIsMissing) {
  for (const int frames : {1, 2, 3}) {
    AppStage stage;
    ASSERT_TRUE(stage.open_text("short.bvh", small_bvh(frames)));
    for (const char* command : {"analysis.layout", "view.com", "view.arrows.acceleration"}) stage.app().run_command(command, nullptr);
    for (const char* method : {"central", "butterworth:6", "savgol:7,3", "gcv"}) {
      stage.app().run_command("analysis.method", {{"derivative", method}});
      stage.settle();
      EXPECT_EQ(stage.state()["frames"], frames);
    }
  }
}

}  // namespace
}  // namespace marey::app
