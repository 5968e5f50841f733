#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/editing/operation.h"
#include "tests/app/support/app_stage.h"

namespace marey::app {
namespace {

nlohmann::json take_step(AppStage& stage, const std::string& step) {
  return stage.app().run_command("edit.operation", {{"do", step}});
}

TEST(OperationCommand, TakesAStepThatUndoTakesBack) {
  AppStage stage;
  stage.open_sample("walk");
  const std::string before = stage.app().save_text();
  const nlohmann::json answer = take_step(stage, "smooth sigma=3 frames=10:60");
  ASSERT_FALSE(answer.contains("error")) << answer;
  EXPECT_EQ(answer["changed"], true);
  EXPECT_EQ(stage.state()["undoDepth"], 1);
  EXPECT_NE(stage.app().save_text(), before);
  stage.app().run_command("edit.undo", nullptr);
  EXPECT_EQ(stage.app().save_text(), before);
}

TEST(OperationCommand, LetsTheFigureGoAndPlaysIt) {
  AppStage stage;
  stage.open_sample("giant-swing");
  stage.app().session().playback.set_playing(false);
  stage.app().run_command("play.go_to_frame", {{"frame", 5}});
  stage.settle();
  const std::string before = stage.app().save_text();
  const nlohmann::json answer = stage.app().run_command("analysis.let_go", nullptr);
  ASSERT_FALSE(answer.contains("error")) << answer;
  EXPECT_NE(answer["notes"][0].get<std::string>().find("Energy drifts by"), std::string::npos);
  constexpr int kKept = 6;  // frames 0 to 5
  EXPECT_EQ(stage.app().session().document.motion().frame_count(), kKept + 150);
  EXPECT_TRUE(stage.app().session().playback.is_playing());
  stage.app().run_command("edit.undo", nullptr);
  EXPECT_EQ(stage.app().save_text(), before);
}

TEST(OperationCommand, SaysWhatIsWrong) {
  AppStage stage;
  EXPECT_TRUE(take_step(stage, "smooth").contains("error"));
  stage.open_sample("walk");
  for (const std::string step : {"", "smoth", "smooth sigma", "smooth sigma=-1", "smooth joints=Nobody"}) {
    EXPECT_TRUE(take_step(stage, step).contains("error")) << step;
  }
  EXPECT_NE(take_step(stage, "smoth")["error"].get<std::string>().find("smooth"), std::string::npos);
  EXPECT_EQ(stage.state()["undoDepth"], 0);
}

// Operations on the figure too: everything that is drawn has to follow another number of joints, frames and channels.
TEST(OperationCommand, EveryOperationIsDrawnAndTakenBack) {
  AppStage stage;
  stage.open_sample("walk");
  stage.app().run_command("select.all", nullptr);
  for (const char* command : {"view.trails", "view.strobe", "view.names"}) stage.app().run_command(command, nullptr);
  const std::string before = stage.app().save_text();
  int changed = 0;
  for (const Operation& operation : operations()) {
    SCOPED_TRACE(operation.id);
    const bool needs_words = std::any_of(operation.parameters.begin(), operation.parameters.end(),
                                         [](const OperationParameter& parameter) { return is_text(parameter.kind); });
    const nlohmann::json answer = needs_words ? nlohmann::json{{"error", ""}} : take_step(stage, std::string(operation.id));
    stage.wait(0.5);
    stage.settle();
    if (answer.contains("error")) continue;
    if (answer["changed"] == true) {
      ++changed;
      stage.app().run_command("edit.undo", nullptr);
      stage.settle();
    }
    ASSERT_EQ(stage.app().save_text(), before);
  }
  EXPECT_GT(changed, 12);
}

}  // namespace
}  // namespace marey::app
