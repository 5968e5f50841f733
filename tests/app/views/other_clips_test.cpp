#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/biomechanics/chosen_body.h"
#include "core/biomechanics/own_segments.h"
#include "core/editing/clip_operations.h"
#include "tests/app/support/app_stage.h"
#include "wasm/views/analysis/plot_row.h"

namespace marey::app {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

/// The giant swing in the analysis layout, its trunk selected at frame 8.
class OtherClipsTest : public testing::Test {
 protected:
  void SetUp() override {
    stage_.open_sample("giant-swing");
    stage_.app().session().playback.set_playing(false);
    stage_.app().session().selection.select_only(1);
    stage_.app().session().playback.set_position(7);
    stage_.app().run_command("analysis.layout", nullptr);
    stage_.settle();
    text_ = stage_.app().save_text();
  }

  void read_beside(const std::string& name, const std::string& text) {
    ASSERT_TRUE(stage_.app().begin_loading(name, 0, FileUse::OtherClip));
    ASSERT_TRUE(stage_.app().feed_loading(text));
    ASSERT_TRUE(stage_.app().finish_loading());
    stage_.settle();
  }
  /// The same clip with its first frame time replaced.
  [[nodiscard]] std::string with_frame_time(const std::string& frame_time) const {
    const std::size_t at = text_.find("Frame Time:");
    return text_.substr(0, at) + "Frame Time: " + frame_time + text_.substr(text_.find('\n', at));
  }
  [[nodiscard]] Json plots() { return stage_.state()["analysis"]["plots"]; }
  [[nodiscard]] const Clip& clip() { return stage_.app().session().document.clip(); }

  AppStage stage_;
  std::string text_;
};

TEST_F(OtherClipsTest, AreDrawnBesideTheOpenOneAtTheirOwnTimes) {
  read_beside("same.bvh", text_);
  read_beside("slow.bvh", with_frame_time("0.066666"));
  EXPECT_THAT(stage_.state()["otherFiles"], ElementsAre("same.bvh", "slow.bvh"));
  ASSERT_EQ(plots()[0]["others"].size(), 2u);
  EXPECT_EQ(plots()[0]["others"][0], plots()[0]["values"]);
  EXPECT_EQ(plots()[3]["others"][0], plots()[3]["values"]);
  const auto angle = clip().motion.channel_samples(clip().skeleton.first_channel(1));
  const double between = 0.5 * (angle[3] + angle[4]);
  const Json slow = plots()[0]["others"][1];
  const std::string axis(1, static_cast<char>('x' + static_cast<int>(axis_of(clip().skeleton.channel(clip().skeleton.first_channel(1)).kind))));
  EXPECT_NEAR(slow[axis].get<double>(), between, 1e-3);
  EXPECT_TRUE(stage_.shows("plots.other.0"));
  EXPECT_EQ(stage_.item("plots.other.1").label, "slow.bvh");
}

// What is compared is the movement: the same figure has the same body.
TEST_F(OtherClipsTest, HaveTheBodyOfTheOpenOneWhereTheFigureIsTheSame) {
  read_beside("same.bvh", text_);
  ASSERT_TRUE(stage_.app().session().apply(make_body_edit(clip(), with_segment_mass(clip(), 2, 90.0))));
  stage_.settle();
  const double torque = plots()[3]["values"]["z"].get<double>();
  EXPECT_EQ(plots()[3]["others"][0]["z"].get<double>(), torque);
  stage_.app().run_command("edit.undo", nullptr);
  stage_.settle();
  EXPECT_NE(plots()[3]["values"]["z"].get<double>(), torque);
  EXPECT_EQ(plots()[3]["others"][0], plots()[3]["values"]);
}

TEST_F(OtherClipsTest, HaveTheUnitOfTheOpenOneWhereTheFigureIsTheSame) {
  stage_.app().run_command("analysis.plots", {{"quantities", {"position:Legs", "torque"}}});
  read_beside("same.bvh", text_);
  ClipSettings settings = clip().settings;
  settings.metres_per_unit *= 2.0;
  ASSERT_TRUE(stage_.app().session().apply(make_settings_edit(clip(), settings)));
  stage_.settle();
  EXPECT_EQ(plots()[0]["others"][0], plots()[0]["values"]);
  EXPECT_EQ(plots()[1]["others"][0], plots()[1]["values"]);
}

// Another figure: the same mass by the same table, under the same gravity.
TEST_F(OtherClipsTest, WeighAsMuchAsTheOpenOneWhereTheFigureIsAnother) {
  stage_.app().run_command("analysis.plots", {{"quantities", {"com", "potential_energy"}}});
  std::string other = text_;
  other.replace(other.find("Legs"), 4, "Shanks");
  BodyChoice body = choose_model(clip().body, find_chosen_body(clip())->body.model);
  body.segments[0].mass_kg = 50.0;
  body.gravity_mps2 = glm::dvec3(0.0, -1.62, 0.0);
  ASSERT_TRUE(stage_.app().session().apply(make_body_edit(clip(), body)));
  read_beside("other.bvh", other);
  EXPECT_NE(plots()[1]["others"][0], plots()[1]["values"]);
  const Clip& beside = stage_.app().session().others[0]->clip;
  BodyChoice expected;
  expected.mass_kg = find_chosen_body(clip())->mass_kg;
  expected.gravity_mps2 = body.gravity_mps2;
  AnalysisRequest request;
  request.quantities = {"potential_energy"};
  request.model = find_chosen_body(beside.skeleton, expected, beside.settings.metres_per_unit)->body.model;
  EXPECT_NEAR(plots()[1]["others"][0]["value"].get<double>(), analyse(beside, request)->columns[0].values[7], 1e-9);
}

TEST_F(OtherClipsTest, AreTakenAwayOneByOne) {
  for (const char* name : {"a.bvh", "b.bvh", "c.bvh", "d.bvh", "e.bvh"}) read_beside(name, text_);
  EXPECT_THAT(stage_.state()["otherFiles"], ElementsAre("b.bvh", "c.bvh", "d.bvh", "e.bvh"));
  EXPECT_EQ(plots()[0]["others"].size(), 4u);
  stage_.click("plots.other.1.remove");
  stage_.settle();
  EXPECT_THAT(stage_.state()["otherFiles"], ElementsAre("b.bvh", "d.bvh", "e.bvh"));
  EXPECT_EQ(plots()[0]["others"].size(), 3u);
  EXPECT_EQ(stage_.app().save_text(), text_);
  for (int i = 0; i < 3; ++i) {
    stage_.click("plots.other.0.remove");
    stage_.settle();
  }
  EXPECT_FALSE(stage_.shows("plots.other.0"));
  EXPECT_TRUE(plots()[0]["others"].empty());
}

// One is read after the other was taken away, perhaps into the same memory.
TEST_F(OtherClipsTest, AreNotTakenForOneThatIsGone) {
  for (int i = 0; i < 4; ++i) {
    read_beside("same.bvh", text_);
    EXPECT_EQ(plots()[0]["others"][0], plots()[0]["values"]);
    stage_.click("plots.other.0.remove");
    stage_.settle();
    read_beside("slow.bvh", with_frame_time("0.066666"));
    EXPECT_NE(plots()[0]["others"][0], plots()[0]["values"]);
    stage_.click("plots.other.0.remove");
    stage_.settle();
  }
}

// Three times the frame rate, so that two of three frames lie between those of the open clip.
TEST_F(OtherClipsTest, AreMeasuredByTheirOwnFrames) {
  stage_.app().run_command("analysis.plots", {{"quantities", {"angle"}}});
  read_beside("quick.bvh", with_frame_time("0.011111"));
  stage_.click("plots.mode");
  stage_.settle();
  stage_.click("plots.mode.statistics");
  stage_.settle();
  const auto angle = clip().motion.channel_samples(clip().skeleton.first_channel(1));
  const std::size_t components = plots()[0]["values"].size();
  const std::string highest = std::to_string(2 * components - 1);
  EXPECT_EQ(stage_.item("plots.statistics." + highest + ".highest").label, value_text(*std::max_element(angle.begin(), angle.end())).view());
}

TEST_F(OtherClipsTest, AreInTheStatisticsAndInTheDrawingForPrint) {
  read_beside("a.bvh", text_);
  read_beside("slow.bvh", with_frame_time("0.066666"));
  stage_.click("plots.mode");
  stage_.settle();
  stage_.click("plots.mode.statistics");
  stage_.settle();
  const std::string owner = clip().skeleton.name(1);
  const std::string second = "plots.statistics.1";
  EXPECT_EQ(stage_.item("plots.statistics.0.of").label, owner);
  EXPECT_EQ(stage_.item(second + ".of").label, owner + " · a.bvh");
  EXPECT_EQ(stage_.item(second + ".highest").label, stage_.item("plots.statistics.0.highest").label);
  stage_.app().run_command("analysis.save_svg", nullptr);
  const std::string& drawing = stage_.log().downloads.back().second;
  EXPECT_THAT(drawing, HasSubstr(">slow.bvh</text>"));
  EXPECT_THAT(drawing, HasSubstr("stroke-dasharray=\"0.9 1.8\""));
}

TEST(DashesOfClips, AreNoTwoTheSame) {
  for (std::size_t a = 0; a < kMostOtherClips; ++a) {
    for (std::size_t b = 0; b < a; ++b) EXPECT_FALSE(std::equal(dashes_of(a).begin(), dashes_of(a).end(), dashes_of(b).begin(), dashes_of(b).end()));
    EXPECT_EQ(dashes_of(a).size() % 2, 0u);
  }
}

}  // namespace
}  // namespace marey::app
