#include <gtest/gtest.h>

#include <string>

#include "tests/app/support/allocation_count.h"
#include "tests/app/support/app_stage.h"

namespace marey::app {
namespace {

// Buffers grow while the clip plays for the first time; after that each frame finds what it needs.
std::size_t blocks_while_playing(AppStage& stage) {
  constexpr int kFrames = 240;
  stage.app().run_command("play.toggle", nullptr);
  for (int i = 0; i < kFrames; ++i) stage.frame();
  std::size_t blocks = 0;
  {
    const AllocationCount count;
    for (int i = 0; i < kFrames; ++i) stage.frame();
    blocks = count.blocks();
  }
  EXPECT_EQ(stage.state()["playing"], true);
  return blocks;
}

TEST(Playing, AllocatesNothing) {
  AppStage stage;
  stage.open_sample("walk");
  stage.wait(10.0);
  stage.settle();
  EXPECT_EQ(blocks_while_playing(stage), 0u);
}

TEST(Playing, AllocatesNothingWithManyCurvesTrailsAndStepsToUndo) {
  AppStage stage;
  stage.open_sample("walk");
  for (const char* command : {"select.all", "view.trails", "view.strobe", "view.names"}) stage.app().run_command(command, nullptr);
  stage.app().run_command("curve.select", {{"channel", 3}, {"first", 2}, {"count", 40}});
  stage.app().run_command("curve.move", {{"delta", 2.0}});
  stage.wait(10.0);
  stage.settle();
  EXPECT_EQ(blocks_while_playing(stage), 0u);
}

TEST(Playing, IsCountedByWhatTakesMemory) {
  const AllocationCount count;
  const std::string text(100, 'x');
  EXPECT_EQ(text.size(), 100u);
  EXPECT_GT(count.blocks(), 0u);
}

}  // namespace
}  // namespace marey::app
