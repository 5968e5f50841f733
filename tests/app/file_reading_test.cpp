#include "wasm/app/file_reading.h"

#include <gtest/gtest.h>

#include "tests/app/support/app_stage.h"

namespace marey::app {
namespace {

std::string channel_table(const std::string& column) { return "frame,time," + column + "\n1,0,10\n2,0.5,20\n"; }

TEST(OpeningATable, TakesTheFigureOfTheOpenClip) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("arm.bvh", small_bvh(3)).ok());
  const Skeleton figure = stage.app().session().document.skeleton();
  const std::string column = figure.name(0) + "." + std::string(channel_keyword(figure.channel(0).kind));
  ASSERT_TRUE(stage.open_text("Arm.CSV", channel_table(column)).ok());
  const Document& document = stage.app().session().document;
  EXPECT_EQ(document.skeleton(), figure);
  EXPECT_EQ(document.motion().frame_count(), 2);
  EXPECT_EQ(document.motion().frame_time_s(), 0.5);
  EXPECT_EQ(document.motion().sample(0, 1), 20.0);
  EXPECT_FALSE(document.is_dirty());
}

TEST(OpeningATable, OfPointsNeedsNoFigure) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("markers.csv", "time,A.x,A.y,B.z\n0,1,2,3\n0.1,4,5,6\n").ok());
  const Document& document = stage.app().session().document;
  EXPECT_EQ(document.skeleton().joint_count(), 2);
  EXPECT_EQ(document.motion().sample(2, 1), 6.0);
}

TEST(OpeningATable, OfChannelsWithoutAFigureSaysWhatToDo) {
  const Result<BvhClip> clip = read_opened_table(channel_table("Hips.Zrotation"), nullptr);
  ASSERT_FALSE(clip);
  EXPECT_EQ(clip.error().code, DiagnosticCode::TableKind);
  EXPECT_NE(clip.error().message.find("Open that file first"), std::string::npos);
}

TEST(OpeningATable, ThatDoesNotFitLeavesTheOpenClip) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("arm.bvh", small_bvh(3)).ok());
  EXPECT_FALSE(stage.open_text("other.csv", channel_table("Tail.Zrotation")).ok());
  EXPECT_EQ(stage.app().session().document.file_name(), "arm.bvh");
}

}  // namespace
}  // namespace marey::app
