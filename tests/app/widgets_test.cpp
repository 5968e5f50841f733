#include "wasm/app/widgets.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/app/support/widget_stage.h"

namespace marey::app {
namespace {

Command counting(std::string id, int& runs, Reason reason = "") {
  return {.id = std::move(id),
          .label = "Do it",
          .help = "Does it.",
          .run = [&runs](const nlohmann::json&) -> nlohmann::json { return ++runs; },
          .blocked = [reason] { return reason; }};
}

TEST(CommandButton, RunsOnClickAndNotWhenBlocked) {
  WidgetStage stage([](ViewContext& context) {
    ui::command_button(context, "free");
    ui::command_button(context, "blocked");
    ui::command_button(context, "unknown");
  });
  int free_runs = 0;
  int blocked_runs = 0;
  stage.commands().add(counting("free", free_runs));
  stage.commands().add(counting("blocked", blocked_runs, "Not now."));
  stage.frame(2);
  stage.click("free");
  stage.click("blocked");
  EXPECT_EQ(free_runs, 1);
  EXPECT_EQ(blocked_runs, 0);
  EXPECT_FALSE(is_shown(stage.items(), "unknown"));
}

TEST(CommandButton, SpacePressesTheFocusedOne) {
  WidgetStage stage([](ViewContext& context) { ui::command_button(context, "free"); });
  int runs = 0;
  stage.commands().add(counting("free", runs));
  stage.frame(2);
  stage.press(ImGuiKey_Tab);
  stage.press(ImGuiKey_Space);
  EXPECT_EQ(runs, 1);
}

TEST(SearchField, ReportsChangesAndClears) {
  std::string text;
  int changes = 0;
  WidgetStage stage([&](ViewContext& context) { changes += ui::search_field(context, "search", "Find", text) ? 1 : 0; });
  stage.click("search");
  stage.type("hip");
  EXPECT_EQ(text, "hip");
  EXPECT_GE(changes, 1);
  stage.click("search.clear");
  EXPECT_EQ(text, "");
  EXPECT_FALSE(is_shown(stage.items(), "search.clear"));
}

TEST(Toggle, TurnsOverOnClick) {
  bool on = false;
  WidgetStage stage([&](ViewContext& context) { ui::toggle(context, "toggle", "Grid", "Shows it.", on); });
  stage.click("toggle");
  EXPECT_TRUE(on);
  stage.click("toggle");
  EXPECT_FALSE(on);
}

TEST(Choice, OpensAListAndTakesWhatIsClicked) {
  const std::vector<ui::ChoiceOption> options = {{"speed.half", "0.5×"}, {"speed.one", "1×"}, {"speed.two", "2×"}};
  int chosen = 1;
  int changes = 0;
  WidgetStage stage([&](ViewContext& context) {
    changes += ui::choice(context, "speed", "Speed", "How fast.", options, chosen, 80.0f) ? 1 : 0;
  });
  EXPECT_FALSE(is_shown(stage.items(), "speed.half"));
  stage.click("speed");
  stage.click("speed.two");
  EXPECT_EQ(chosen, 2);
  EXPECT_EQ(changes, 1);
  EXPECT_FALSE(is_shown(stage.items(), "speed.half"));
  stage.click("speed");
  stage.click("speed.two");
  EXPECT_EQ(changes, 1) << "the chosen one again is no change";
  stage.click("speed");
  stage.press(ImGuiKey_Escape);
  EXPECT_FALSE(is_shown(stage.items(), "speed.half"));
  EXPECT_EQ(chosen, 2);
}

TEST(ElidedText, NeverIsWiderThanAsked) {
  const std::string name = "Очень длинное имя сустава, шестьдесят знаков и ещё немного хвост";
  float width = 0.0f;
  WidgetStage stage([&](ViewContext& context) {
    ui::elided_text(context, name, 120.0f, context.theme.text);
    width = ImGui::GetItemRectSize().x;
  });
  EXPECT_LE(width, 120.5f);
  EXPECT_GT(width, 80.0f);
}

TEST(Displayable, KeepsUtf8AndReplacesWhatIsNot) {
  EXPECT_EQ(ui::displayable("Колено"), "Колено");
  EXPECT_EQ(ui::displayable("a\xFF" "b"), "a\xEF\xBF\xBD" "b");
  EXPECT_EQ(ui::displayable(""), "");
  const std::string cut = ui::displayable("Knie\xD0");
  EXPECT_EQ(cut.substr(0, 4), "Knie");
}

}  // namespace
}  // namespace marey::app
