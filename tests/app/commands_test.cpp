#include "wasm/app/commands.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/app/support/app_stage.h"
#include "wasm/app/builtin_commands.h"
#include "wasm/app/shortcut.h"

namespace marey::app {
namespace {

using nlohmann::json;

TEST(CommandRegistry, RunsByIdAndPassesArguments) {
  CommandRegistry registry;
  registry.add({.id = "a.b", .label = "A", .help = "H.", .run = [](const json& args) { return args; }});
  EXPECT_EQ(registry.run("a.b", {{"x", 1}}), (json{{"x", 1}}));
  EXPECT_NE(registry.find("a.b"), nullptr);
  EXPECT_EQ(registry.find("a"), nullptr);
}

TEST(CommandRegistry, SaysWhyItRefuses) {
  CommandRegistry registry;
  int runs = 0;
  registry.add({.id = "a",
                .label = "A",
                .help = "H.",
                .run = [&](const json&) -> json { return ++runs; },
                .blocked = [] { return "Not now."; }});
  EXPECT_EQ(registry.run("a")["error"], "Not now.");
  EXPECT_EQ(runs, 0);
  EXPECT_NE(registry.run("nothing")["error"].get<std::string>().find("nothing"), std::string::npos);
}

TEST(BuiltinCommands, DownloadNamesEndWithBvh) {
  EXPECT_EQ(download_name("walk.bvh"), "walk.bvh");
  EXPECT_EQ(download_name("walk.BVH"), "walk.bvh");
  EXPECT_EQ(download_name("take.1.txt"), "take.1.bvh");
  EXPECT_EQ(download_name("walk"), "walk.bvh");
  EXPECT_EQ(download_name(""), "clip.bvh");
}

bool ends_as_sentence(const std::string& text) { return !text.empty() && text.back() == '.'; }

TEST(AllCommands, HaveLabelHelpAndShortcutOfTheirOwn) {
  AppStage stage;
  std::map<ImGuiKeyChord, std::string> owners;
  int shortcuts = 0;
  for (const json& command : stage.app().commands()) {
    const std::string id = command["id"];
    const std::string label = command["label"];
    EXPECT_FALSE(label.empty()) << id;
    EXPECT_FALSE(ends_as_sentence(label)) << id;
    EXPECT_TRUE(ends_as_sentence(command["help"])) << id;
    EXPECT_EQ(std::string(command["help"]).find('!'), std::string::npos) << id;
    if (command["shortcut"].is_null()) continue;
    for (const ImGuiKeyChord chord : parse_shortcuts(command["shortcut"].get<std::string>())) {
      EXPECT_TRUE(owners.emplace(chord, id).second) << id << " and " << owners[chord] << " share " << command["shortcut"];
      ++shortcuts;
    }
  }
  EXPECT_GE(shortcuts, 25);
}

TEST(AllCommands, ShortcutsCanAllBeParsed) {
  AppStage stage;
  for (const json& command : stage.app().commands()) {
    if (command["shortcut"].is_null()) continue;
    const std::string text = command["shortcut"];
    const auto listed = static_cast<std::size_t>(std::count(text.begin(), text.end(), ',') + 1);
    EXPECT_EQ(parse_shortcuts(text).size(), listed) << command["id"];
  }
}

// Each command either runs or says why not, in a sentence; none brings the program down.
void expect_run_or_reason(AppStage& stage) {
  std::set<std::string> ids;
  for (const json& command : stage.app().commands()) ids.insert(command["id"].get<std::string>());
  for (const std::string& id : ids) {
    for (const json& args : {json(nullptr), json::object(), json{{"on", "maybe"}, {"frame", -7}, {"joint", 1e9}}}) {
      const json result = stage.app().run_command(id, args);
      if (result.is_object() && result.contains("error")) {
        EXPECT_TRUE(ends_as_sentence(result["error"])) << id << ": " << result["error"];
      }
      stage.frame();
    }
  }
}

TEST(AllCommands, RunOrSayWhyWithoutAFile) {
  AppStage stage;
  expect_run_or_reason(stage);
}

TEST(AllCommands, RunOrSayWhyWithAFile) {
  AppStage stage;
  stage.open_sample("walk");
  expect_run_or_reason(stage);
}

TEST(AllCommands, RunOrSayWhyWithOneFrame) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("one.bvh", small_bvh(1)).ok());
  expect_run_or_reason(stage);
}

TEST(AllCommands, RunOrSayWhyWithoutFrames) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("none.bvh", small_bvh(0)).ok());
  expect_run_or_reason(stage);
  EXPECT_FALSE(stage.app().run_command("play.toggle", nullptr)["error"].is_null());
}

TEST(PlayCommands, StepGoAndKeepTheRange) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("five.bvh", small_bvh(5)).ok());
  stage.app().run_command("play.next", nullptr);
  EXPECT_EQ(stage.state()["frame"], 1);
  stage.app().run_command("play.go_to_frame", {{"frame", 3}});
  EXPECT_EQ(stage.state()["frame"], 3);
  stage.app().run_command("play.range_out", nullptr);
  stage.app().run_command("play.first", nullptr);
  EXPECT_EQ(stage.state()["frame"], 0);
  stage.app().run_command("play.last", nullptr);
  EXPECT_EQ(stage.state()["frame"], 3);
  stage.app().run_command("play.range_clear", nullptr);
  EXPECT_EQ(stage.state()["range"]["count"], 5);
}

TEST(PlayCommands, WrongArgumentsAreRefusedWithASentence) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("five.bvh", small_bvh(5)).ok());
  for (const json& args : {json(nullptr), json{{"frame", "two"}}, json{{"frame", 5}}, json{{"frame", -1}}}) {
    const json result = stage.app().run_command("play.go_to_frame", args);
    EXPECT_TRUE(result.is_object() && ends_as_sentence(result["error"])) << args;
  }
  EXPECT_EQ(stage.state()["frame"], 0);
}

TEST(ClipCommands, SettingsAreEditsThatCanBeUndone) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("five.bvh", small_bvh(5)).ok());
  const std::string before = stage.state()["upAxis"];
  stage.app().run_command(before == "Y" ? "clip.up_axis.z" : "clip.up_axis.y", nullptr);
  EXPECT_NE(stage.state()["upAxis"], before);
  EXPECT_EQ(stage.state()["undoDepth"], 1);
  EXPECT_FALSE(stage.state()["undoName"].get<std::string>().empty());
  stage.app().run_command("edit.undo", nullptr);
  EXPECT_EQ(stage.state()["upAxis"], before);
  stage.app().run_command("edit.redo", nullptr);
  EXPECT_NE(stage.state()["upAxis"], before);
}

TEST(SelectCommands, WalkTheTree) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("five.bvh", small_bvh(5)).ok());
  EXPECT_EQ(stage.app().run_command("select.joint", {{"joint", 1}}), "Middle");
  stage.app().run_command("select.child", nullptr);
  EXPECT_EQ(stage.state()["selection"]["activeJoint"], 2);
  EXPECT_TRUE(stage.app().run_command("select.child", nullptr).contains("error"));
  stage.app().run_command("select.parent", nullptr);
  stage.app().run_command("select.parent", nullptr);
  EXPECT_EQ(stage.state()["selection"]["activeJoint"], 0);
  EXPECT_TRUE(stage.app().run_command("select.parent", nullptr).contains("error"));
  stage.app().run_command("select.none", nullptr);
  EXPECT_TRUE(stage.state()["selection"]["joints"].empty());
}

TEST(ViewCommands, ScaleGoesInStepsAndStopsAtTheEnds) {
  AppStage stage;
  for (int i = 0; i < 20; ++i) stage.app().run_command("view.scale.larger", nullptr);
  EXPECT_FLOAT_EQ(stage.state()["interfaceScale"], 2.5f);
  EXPECT_TRUE(stage.app().run_command("view.scale.larger", nullptr).contains("error"));
  for (int i = 0; i < 20; ++i) stage.app().run_command("view.scale.smaller", nullptr);
  EXPECT_FLOAT_EQ(stage.state()["interfaceScale"], 1.0f);
  EXPECT_EQ(stage.app().run_command("view.scale", {{"percent", 150}}), 150);
  EXPECT_TRUE(stage.app().run_command("view.scale", {{"percent", 300}}).contains("error"));
}

TEST(FileCommands, DownloadHandsTheTextOverAndClearsTheMark) {
  AppStage stage;
  ASSERT_TRUE(stage.open_text("five.txt", small_bvh(5)).ok());
  stage.app().run_command("clip.frame_time", {{"seconds", 0.2}});
  stage.settle();
  EXPECT_TRUE(stage.log().dirty);
  stage.app().run_command("file.save", nullptr);
  stage.settle();
  ASSERT_EQ(stage.log().downloads.size(), 1u);
  EXPECT_EQ(stage.log().downloads[0].first, "five.bvh");
  EXPECT_NE(stage.log().downloads[0].second.find("HIERARCHY"), std::string::npos);
  EXPECT_FALSE(stage.log().dirty);
  EXPECT_FALSE(stage.state()["dirty"]);
}

}  // namespace
}  // namespace marey::app
