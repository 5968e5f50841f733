// A file that is read by pieces: progress, its first frames while it comes, and what was open before.
#include <gtest/gtest.h>

#include "tests/app/support/app_stage.h"
#include "wasm/views/loading_strip.h"

namespace marey::app {
namespace {

/// Feeds a file of many rows a share at a time, with frames in between, as the page does.
class Slow {
 public:
  Slow(AppStage& stage, std::string name, std::string text) : stage_(stage), text_(std::move(text)) {
    EXPECT_TRUE(stage_.app().begin_loading(std::move(name), static_cast<std::int64_t>(text_.size())).ok());
  }

  bool feed(double share) {
    const auto end = static_cast<std::size_t>(share * static_cast<double>(text_.size()));
    bool wants_more = true;
    while (wants_more && fed_ < end) {
      const std::string_view piece = std::string_view(text_).substr(fed_, std::min<std::size_t>(40'000, end - fed_));
      wants_more = stage_.app().feed_loading(piece);
      fed_ += piece.size();
      stage_.wait(0.1);
      stage_.frame();
    }
    return wants_more;
  }

 private:
  AppStage& stage_;
  std::string text_;
  std::size_t fed_ = 0;
};

constexpr int kManyFrames = 40'000;

TEST(Loading, ShowsTheFirstFramesWhileTheFileComes) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("arm.bvh", small_bvh(3)).ok());
  Slow slow(stage, "long.bvh", small_bvh(kManyFrames));
  ASSERT_TRUE(slow.feed(0.5));
  EXPECT_EQ(stage.state()["file"], "long.bvh");
  EXPECT_EQ(stage.state()["loading"]["file"], "long.bvh");
  const int half = stage.state()["frames"];
  EXPECT_GT(half, kManyFrames / 4);
  stage.app().run_command("play.go_to_frame", {{"frame", 100}});
  ASSERT_TRUE(slow.feed(1.0));
  EXPECT_GT(static_cast<int>(stage.state()["frames"]), half);
  EXPECT_EQ(stage.state()["frame"], 100);
  ASSERT_TRUE(stage.app().finish_loading().ok());
  EXPECT_EQ(stage.state()["frames"], kManyFrames);
  EXPECT_EQ(stage.state()["frame"], 100);
  EXPECT_TRUE(stage.state()["loading"].is_null());
  EXPECT_EQ(stage.app().save_text(), small_bvh(kManyFrames));
}

TEST(Loading, StoppedBringsBackWhatWasOpen) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("arm.bvh", small_bvh(3)).ok());
  stage.app().run_command("clip.frame_time", {{"seconds", 0.5}});
  const std::string edited = stage.app().save_text();
  Slow slow(stage, "long.bvh", small_bvh(kManyFrames));
  ASSERT_TRUE(slow.feed(0.6));
  EXPECT_EQ(stage.app().save_text(), edited);
  stage.click("file.cancel_loading.strip");
  EXPECT_EQ(stage.state()["file"], "arm.bvh");
  EXPECT_EQ(stage.app().save_text(), edited);
  EXPECT_EQ(stage.state()["undoDepth"], 1);
  EXPECT_EQ(stage.log().stopped_loadings, 1);
  EXPECT_FALSE(slow.feed(1.0));
  EXPECT_EQ(stage.app().finish_loading().error().code, DiagnosticCode::Cancelled);
  EXPECT_EQ(stage.state()["file"], "arm.bvh");
}

TEST(Loading, EscapeStopsIt) {
  AppStage stage;
  Slow slow(stage, "long.bvh", small_bvh(kManyFrames));
  ASSERT_TRUE(slow.feed(0.4));
  stage.press(ImGuiKey_Escape);
  EXPECT_TRUE(stage.state()["loading"].is_null());
  EXPECT_TRUE(stage.state()["file"].is_null());
}

TEST(Loading, RefusesEditsAndDownloadsOfAPart) {
  AppStage stage;
  Slow slow(stage, "long.bvh", small_bvh(kManyFrames));
  ASSERT_TRUE(slow.feed(0.5));
  for (const char* id : {"file.save", "file.save_as", "clip.up_axis.z", "clip.frame_time", "clip.remove_frames"}) {
    const nlohmann::json answer = stage.app().run_command(id, {{"seconds", 0.5}, {"first", 0}, {"count", 1}});
    EXPECT_TRUE(answer.is_object() && answer.contains("error")) << id;
  }
  Edit edit;
  edit.name = "Move";
  edit.offsets.push_back({0, glm::dvec3(1.0)});
  EXPECT_FALSE(stage.app().session().apply(edit).ok());
  EXPECT_EQ(stage.state()["undoDepth"], 0);
}

TEST(Loading, KeepsUnsavedChangesOfTheClipBefore) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("arm.bvh", small_bvh(3)).ok());
  stage.app().run_command("clip.frame_time", {{"seconds", 0.5}});
  Slow slow(stage, "long.bvh", small_bvh(kManyFrames));
  ASSERT_TRUE(slow.feed(1.0));
  ASSERT_TRUE(stage.app().finish_loading().ok());
  stage.app().run_command("file.previous", {});
  EXPECT_EQ(stage.state()["file"], "arm.bvh");
  EXPECT_EQ(stage.state()["frameTime"], 0.5);
}

TEST(Loading, AFileThatTurnsOutUnreadableLeavesWhatWasOpen) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("arm.bvh", small_bvh(3)).ok());
  ASSERT_TRUE(stage.app().begin_loading("bad.bvh", 0).ok());
  stage.app().feed_loading("no BVH at all");
  EXPECT_FALSE(stage.app().finish_loading().ok());
  EXPECT_EQ(stage.state()["file"], "arm.bvh");
  EXPECT_EQ(stage.state()["messages"].size(), 1U);
}

TEST(Loading, SaysMegabytesAndSecondsLeft) {
  EXPECT_EQ(progress_text(1'200'000, 500'000'000, 0.1), "1.2 of 500 MB");
  EXPECT_EQ(progress_text(125'000'000, 500'000'000, 1.0), "125 of 500 MB, 3 s left");
  EXPECT_EQ(progress_text(500'000'000, 500'000'000, 4.0), "500 of 500 MB, 0 s left");
  EXPECT_EQ(progress_text(12'000'000, 0, 4.0), "12 MB");
}

}  // namespace
}  // namespace marey::app
