#include "wasm/views/analysis/contact_strip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/support/app_stage.h"
#include "wasm/app/contact_rows.h"

namespace marey::app {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;

/// The walk in the analysis layout, its left foot selected.
class ContactStripTest : public testing::Test {
 protected:
  void SetUp() override {
    stage_.open_sample("walk");
    stage_.app().session().playback.set_playing(false);
    stage_.app().run_command("analysis.layout", nullptr);
    const Skeleton& skeleton = clip().skeleton;
    JointIndex foot = 0;
    while (skeleton.name(foot) != "LeftAnkle") ++foot;
    stage_.app().session().selection.select_only(foot);
    stage_.settle();
  }

  [[nodiscard]] Json contacts() { return stage_.state()["analysis"]["contacts"]; }
  [[nodiscard]] const Clip& clip() { return stage_.app().session().document.clip(); }

  AppStage stage_;
};

TEST(ContactRows, AreRunsOfOneKind) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("three.bvh", small_bvh(8)));
  const Skeleton& skeleton = stage.app().session().document.skeleton();
  Contacts contacts;
  contacts.points = {{0, {}, 0}, {1, {}, 1}, {2, {}, 2}};
  contacts.down = {0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0};  // point 0 in frames 1 2 3 5 6
  const OwnContact own[] = {{0, 2, 2, true}, {0, 4, 4, false}, {2, 6, 7, false}};
  const std::vector<ContactRow> rows = make_contact_rows(skeleton, contacts, own);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_THAT(rows[0].bars, ElementsAre(ContactBar{1, 1, true, false}, ContactBar{2, 2, true, true}, ContactBar{3, 3, true, false},
                                        ContactBar{4, 4, false, true}, ContactBar{5, 6, true, false}));
  EXPECT_EQ(rows[1].node, 2);
  EXPECT_THAT(rows[1].bars, ElementsAre(ContactBar{6, 7, false, true}));
  EXPECT_TRUE(make_contact_rows(skeleton, {}, own).empty());
}

TEST_F(ContactStripTest, StandsAboveThePlotsOfWhatNeedsIt) {
  EXPECT_GE(contacts().size(), 2u);
  EXPECT_TRUE(stage_.shows("contacts.row.0"));
  EXPECT_LT(stage_.item("contacts.row.1").max.y, stage_.item("plots.canvas.0").min.y);
  stage_.app().run_command("analysis.plots", {{"quantities", {"angle"}}});
  stage_.settle();
  EXPECT_TRUE(contacts().empty());
  EXPECT_FALSE(stage_.shows("contacts.row.0"));
  stage_.app().run_command("analysis.plots", {{"quantities", {"reaction"}}});
  stage_.app().run_command("analysis.method", {{"support", "flight"}});
  stage_.settle();
  EXPECT_FALSE(stage_.shows("contacts.row.0"));
}

TEST_F(ContactStripTest, CommandsAreUndoableSteps) {
  const Json before = contacts();
  const Json answer = stage_.app().run_command("analysis.contact_off", {{"first", 10}, {"count", 20}});
  stage_.settle();
  EXPECT_GE(answer["points"], 1);
  EXPECT_EQ(stage_.state()["undoName"], "No contact");
  EXPECT_NE(contacts(), before);
  bool found = false;
  for (const Json& row : contacts()) {
    for (const Json& bar : row["frames"]) {
      if (bar["own"]) found = found || bar == Json{{"first", 10}, {"count", 20}, {"touches", false}, {"own", true}};
    }
  }
  EXPECT_TRUE(found) << contacts();
  stage_.app().run_command("edit.undo", nullptr);
  stage_.settle();
  EXPECT_EQ(contacts(), before);
  EXPECT_EQ(clip().body, BodyChoice{});
}

TEST_F(ContactStripTest, CommandsAreAboutTheRangeElseTheFrame) {
  stage_.app().session().playback.set_position(7);
  EXPECT_EQ(stage_.app().run_command("analysis.contact_on", nullptr)["first"], 7);
  EXPECT_EQ(clip().body.contacts.front().last, 7);
  stage_.app().session().playback.set_range({30, 11});
  EXPECT_EQ(stage_.app().run_command("analysis.contact_on", nullptr)["count"], 11);
  EXPECT_EQ(clip().body.contacts.back().last, 40);
  stage_.app().run_command("analysis.contact_auto", {{"first", 0}, {"count", 41}});
  EXPECT_TRUE(clip().body.contacts.empty());
  EXPECT_EQ(stage_.state()["undoName"], "Contacts as detected");
  stage_.app().session().selection.clear_joints();
  EXPECT_TRUE(stage_.app().run_command("analysis.contact_on", nullptr).contains("error"));
}

TEST_F(ContactStripTest, ABarIsCorrectedByAClickAndTwo) {
  const Json row = contacts()[0];
  const Json bar = row["frames"][0];
  const UiItem item = stage_.item("contacts.row.0");
  TimeWindow time{.left = item.min.x, .right = item.max.x};
  time.fit(clip().motion.frame_count());
  const double middle = bar["first"].get<double>() + 0.5 * bar["count"].get<double>();
  stage_.click_at({time.x_of(middle), 0.5f * (item.min.y + item.max.y)});
  stage_.settle();
  ASSERT_TRUE(stage_.shows("contacts.menu.off"));
  stage_.click("contacts.menu.off");
  stage_.settle();
  EXPECT_EQ(stage_.state()["undoName"], "No contact");
  EXPECT_EQ(stage_.state()["undoDepth"], 1);
  Json expected = bar;
  expected["touches"] = false;
  expected["own"] = true;
  EXPECT_EQ(contacts()[0]["frames"][0], expected);
  EXPECT_EQ(contacts()[0]["point"], row["point"]);
}

}  // namespace
}  // namespace marey::app
