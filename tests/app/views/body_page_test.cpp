#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/biomechanics/chosen_body.h"
#include "tests/app/support/app_stage.h"

namespace marey::app {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

/// The page "Body" of the giant swing, its trunk selected.
class BodyPageTest : public testing::Test {
 protected:
  void SetUp() override {
    stage_.open_sample("giant-swing");
    stage_.app().session().playback.set_playing(false);
    stage_.app().session().selection.select_only(1);
    stage_.app().run_command("view.curves", {{"on", false}});
    stage_.app().run_command("analysis.body", nullptr);
    stage_.resize({.css_width = 1280.0f, .css_height = 1600.0f});
    stage_.settle();
  }

  void type_into(const std::string& item, const std::string& number) {
    stage_.double_click(item);
    stage_.settle();
    stage_.press(ImGuiMod_Ctrl | ImGuiKey_A);
    stage_.type(number);
    stage_.press(ImGuiKey_Enter);
    stage_.settle();
  }
  Status open_model(const std::string& text) {
    App& app = stage_.app();
    if (Status begun = app.begin_loading("model.json", 0, FileUse::BodyModel); !begun) return begun;
    app.feed_loading(text);
    const Status status = app.finish_loading();
    stage_.settle();
    return status;
  }
  [[nodiscard]] const Clip& clip() { return stage_.app().session().document.clip(); }
  [[nodiscard]] Segment segment(JointIndex joint) { return *find_whole_segment(find_chosen_body(clip())->body.model, joint); }

  AppStage stage_;
};

TEST_F(BodyPageTest, CentreAndInertiaOfASegmentCanBeTypedIn) {
  const Segment before = segment(1);
  type_into("body.centre.0", "0.05");
  EXPECT_EQ(segment(1).com_m, glm::dvec3(0.05, before.com_m.y, before.com_m.z));
  EXPECT_EQ(segment(1).mass_kg, before.mass_kg);
  type_into("body.moment.1", "1.25");
  EXPECT_EQ(segment(1).inertia_kgm2[1][1], 1.25);
  EXPECT_EQ(stage_.state()["undoName"], "Change a segment");
  type_into("body.product.2", "0.01");
  EXPECT_EQ(segment(1).inertia_kgm2[1][2], 0.01);
  EXPECT_EQ(segment(1).inertia_kgm2[2][1], 0.01);
  ASSERT_EQ(clip().body.segments.size(), 1u);
  stage_.click("body.segment.reset");
  stage_.settle();
  EXPECT_TRUE(clip().body.segments.empty());
  for (int i = 0; i < 4; ++i) stage_.app().run_command("edit.undo", nullptr);
  EXPECT_EQ(clip().body, BodyChoice{});
}

TEST_F(BodyPageTest, AnInertiaThatNoBodyHasIsRefused) {
  const Segment before = segment(1);
  type_into("body.product.0", "500");
  EXPECT_EQ(segment(1).inertia_kgm2, before.inertia_kgm2);
  EXPECT_TRUE(clip().body.segments.empty());
}

TEST_F(BodyPageTest, AClickOnASegmentSelectsItsJoint) {
  ASSERT_TRUE(stage_.shows("body.joint.0"));
  stage_.app().session().selection.select_only(2);
  stage_.settle();
  stage_.click("body.joint.0");
  stage_.settle();
  const auto body = find_chosen_body(clip());
  EXPECT_EQ(stage_.app().session().selection.active_joint(), body->body.parts[0].joint);
}

TEST_F(BodyPageTest, OwnValuesBeginWithThoseOfTheTable) {
  const double mass = segment(1).mass_kg;
  stage_.click("body.table");
  stage_.settle();
  stage_.click("body.table.own");
  stage_.settle();
  ASSERT_TRUE(clip().body.is_only_own);
  EXPECT_DOUBLE_EQ(segment(1).mass_kg, mass);
  stage_.click("body.segment.reset");
  stage_.settle();
  EXPECT_FALSE(find_whole_segment(find_chosen_body(clip())->body.model, 1));
  type_into("body.segment.mass", "3");
  EXPECT_EQ(segment(1).mass_kg, 3.0) << "a rod in its place";
  EXPECT_GT(glm::length(segment(1).com_m), 0.0);
  stage_.click("body.table");
  stage_.settle();
  stage_.click("body.table.auto");
  stage_.settle();
  EXPECT_EQ(clip().body, BodyChoice{});
}

TEST_F(BodyPageTest, AnotherMassOfTheBodyKeepsWhatWasTypedIn) {
  type_into("body.centre.0", "0.05");
  const Segment trunk = segment(1);
  const double legs = segment(2).mass_kg;
  type_into("body.mass", "146");
  EXPECT_NEAR(find_chosen_body(clip())->mass_kg, 146.0, 1e-9);
  EXPECT_EQ(segment(1).com_m, trunk.com_m);
  EXPECT_NEAR(segment(1).inertia_kgm2[0][0], 2.0 * trunk.inertia_kgm2[0][0], 1e-9);
  EXPECT_NEAR(segment(2).mass_kg, 2.0 * legs, 1e-9);
}

TEST_F(BodyPageTest, GravityIsAnEdit) {
  type_into("body.gravity", "1.62");
  EXPECT_EQ(clip().body.gravity_mps2, glm::dvec3(0.0, -1.62, 0.0));
  type_into("body.gravity", "0");
  type_into("body.gravity", "9.81");
  EXPECT_FALSE(clip().body.gravity_mps2);
}

TEST_F(BodyPageTest, OpensAModelThatItSaved) {
  type_into("body.centre.0", "0.05");
  const BodyModel model = find_chosen_body(clip())->body.model;
  stage_.app().run_command("analysis.save_model", nullptr);
  ASSERT_EQ(stage_.log().downloads.back().first, "giant-swing-body.json");
  const std::string text = stage_.log().downloads.back().second;
  stage_.open_sample("giant-swing");
  stage_.settle();
  stage_.app().run_command("analysis.open_model", nullptr);
  EXPECT_EQ(stage_.log().model_requests, 1);
  ASSERT_TRUE(open_model(text));
  EXPECT_EQ(stage_.state()["undoName"], "Open a model of the body");
  EXPECT_EQ(stage_.state()["file"], "giant-swing.bvh") << "the clip stays";
  const BodyModel opened = find_chosen_body(clip())->body.model;
  EXPECT_DOUBLE_EQ(total_mass_kg(opened), total_mass_kg(model));
  for (JointIndex joint = 0; joint < 3; ++joint) {
    EXPECT_EQ(find_whole_segment(opened, joint)->com_m, find_whole_segment(model, joint)->com_m);
  }
  stage_.app().run_command("edit.undo", nullptr);
  EXPECT_EQ(clip().body, BodyChoice{});
}

TEST_F(BodyPageTest, AModelThatDoesNotFitChangesNothing) {
  const Status no_json = open_model("{\n  \"segments\": [,]\n}");
  ASSERT_FALSE(no_json);
  EXPECT_EQ(no_json.error().place, (TextPlace{2, 16}));
  const Status stranger = open_model(R"({"segments": [{"joint": "Tail", "mass_kg": 1, "com_m": [0, 0, 0]}]})");
  ASSERT_FALSE(stranger);
  EXPECT_THAT(stranger.error().message, HasSubstr("'Tail'"));
  EXPECT_EQ(clip().body, BodyChoice{});
  EXPECT_EQ(stage_.state()["file"], "giant-swing.bvh");
  AppStage empty;
  EXPECT_FALSE(empty.app().begin_loading("model.json", 0, FileUse::BodyModel));
}

}  // namespace
}  // namespace marey::app
