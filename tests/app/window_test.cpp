#include <gtest/gtest.h>

#include <cctype>
#include <string>

#include "tests/app/support/app_stage.h"

namespace marey::app {
namespace {

struct Case {
  const char* name;
  WindowSize window;
  const char* preferences;
};

// What lies over something else on purpose.
bool lies_on_top(const UiItem& item) {
  return item.id.starts_with("splitter.") || item.id == "viewport.canvas" || item.id == "curves.canvas" ||
         item.id.starts_with("viewport.") || item.id.ends_with(".viewport") || item.id.starts_with("timeline.") ||
         item.id.starts_with("curves.");
}

bool contains(const UiItem& outer, const UiItem& inner) {
  return outer.min.x <= inner.min.x && outer.min.y <= inner.min.y && outer.max.x >= inner.max.x && outer.max.y >= inner.max.y;
}

bool overlap(const UiItem& a, const UiItem& b) {
  constexpr float kTouch = 0.5f;
  return a.min.x < b.max.x - kTouch && b.min.x < a.max.x - kTouch && a.min.y < b.max.y - kTouch && b.min.y < a.max.y - kTouch;
}

void expect_tidy(AppStage& stage, const WindowSize& window) {
  const auto& items = stage.app().items().list();
  ASSERT_GT(items.size(), 10u);
  const float scale = stage.app().css_per_unit();
  for (std::size_t i = 0; i < items.size(); ++i) {
    const UiItem& item = items[i];
    EXPECT_GE(item.min.x, -0.5f) << item.id;
    EXPECT_GE(item.min.y, -0.5f) << item.id;
    EXPECT_LE(item.max.x * scale, window.css_width + 0.5f) << item.id;
    EXPECT_LE(item.max.y * scale, window.css_height + 0.5f) << item.id;
    if (lies_on_top(item)) continue;
    for (std::size_t j = i + 1; j < items.size(); ++j) {
      const UiItem& other = items[j];
      if (lies_on_top(other) || contains(item, other) || contains(other, item)) continue;
      EXPECT_FALSE(overlap(item, other)) << item.id << " and " << other.id;
    }
  }
}

class Window : public testing::TestWithParam<Case> {};

TEST_P(Window, ItemsNeitherOverlapNorLeaveThePage) {
  AppStage stage(GetParam().window, GetParam().preferences);
  stage.open_sample("walk");
  stage.app().run_command("select.joint", {{"joint", 2}});
  stage.settle(20);
  expect_tidy(stage, GetParam().window);
}

TEST_P(Window, LongNamesAndManyJointsStayTidy) {
  AppStage stage(GetParam().window, GetParam().preferences);
  std::string name;
  for (int i = 0; i < 12; ++i) name += "Сустав";
  ASSERT_TRUE(stage.open_text(name + name + ".bvh", small_bvh(200, name)).ok());
  stage.app().run_command("select.joint", {{"joint", 2}});
  stage.settle(20);
  expect_tidy(stage, GetParam().window);
}

TEST_P(Window, AMessageTakesRoomFromTheViewportOnly) {
  AppStage stage(GetParam().window, GetParam().preferences);
  stage.open_sample("walk");
  EXPECT_FALSE(stage.open_text("bad.bvh", "nothing").ok());
  stage.settle(20);
  EXPECT_TRUE(stage.shows("message.close"));
  expect_tidy(stage, GetParam().window);
}

TEST_P(Window, OneFrameAndNoFileStayTidy) {
  AppStage stage(GetParam().window, GetParam().preferences);
  expect_tidy(stage, GetParam().window);
  ASSERT_TRUE(stage.open_text("one.bvh", small_bvh(1)).ok());
  stage.settle(20);
  expect_tidy(stage, GetParam().window);
}

constexpr char kSeen[] = R"({"welcomeSeen":true})";

INSTANTIATE_TEST_SUITE_P(
    Sizes, Window,
    testing::Values(Case{"Laptop", {1280.0f, 800.0f, 1.0f}, kSeen}, Case{"FullHd", {1920.0f, 1080.0f, 1.0f}, kSeen},
                    Case{"Phone", {360.0f, 740.0f, 3.0f}, kSeen},
                    Case{"PhoneJoints", {390.0f, 844.0f, 3.0f}, R"({"welcomeSeen":true,"sheet":2})"},
                    Case{"PhoneInspector", {390.0f, 844.0f, 3.0f}, R"({"welcomeSeen":true,"sheet":3})"},
                    Case{"Projector", {1280.0f, 800.0f, 1.0f}, R"({"welcomeSeen":true,"interfaceScale":1.5})"},
                    Case{"Tablet", {768.0f, 1024.0f, 2.0f}, kSeen}),
    [](const auto& tested) { return tested.param.name; });

TEST(Splitters, AreDraggedAndKept) {
  AppStage stage;
  stage.open_sample("walk");
  stage.drag("splitter.outliner", ImVec2(60.0f, 0.0f));
  stage.wait(10.0);
  stage.settle(600);
  EXPECT_NE(stage.log().preferences.find("\"outlinerWidth\":300.0"), std::string::npos) << stage.log().preferences;
  stage.double_click("splitter.outliner");
  stage.wait(10.0);
  stage.settle(600);
  EXPECT_NE(stage.log().preferences.find("\"outlinerWidth\":240.0"), std::string::npos);
}

TEST(Phone, SheetsTakeTurns) {
  AppStage stage({390.0f, 844.0f, 3.0f});
  stage.open_sample("walk");
  EXPECT_EQ(stage.state()["sheet"], "curves");
  stage.click("tab.view.outliner");
  EXPECT_EQ(stage.state()["sheet"], "joints");
  EXPECT_TRUE(stage.shows("outliner.search"));
  stage.click("tab.view.outliner");
  EXPECT_EQ(stage.state()["sheet"], "none");
}

TEST(Phone, EveryMenuEntryCanBeReached) {
  AppStage stage({390.0f, 844.0f, 3.0f});
  stage.open_sample("walk");
  stage.click("menu.all");
  EXPECT_TRUE(stage.shows("menu.file.open"));
  EXPECT_TRUE(stage.shows("menu.help.about"));
}

}  // namespace
}  // namespace marey::app
