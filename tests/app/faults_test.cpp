// What a panel, a command or an edit throws stays where it was thrown.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <cstring>
#include <new>
#include <stdexcept>

#include "tests/app/support/app_stage.h"
#include "wasm/app/panel_guards.h"

namespace marey::app {
namespace {

constexpr ImWchar kFailingLetter = 0x53f3;  // 右
enum class Failure { None, Error, Memory };
Failure failure = Failure::None;

bool is_failing_letter(ImFontAtlas* /*atlas*/, ImFontConfig* /*source*/, ImWchar letter) { return letter == kFailingLetter; }

bool fail_on_letter(ImFontAtlas* /*atlas*/, ImFontConfig* /*source*/, ImFontBaked* /*baked*/, void* /*data*/, ImWchar letter,
                    ImFontGlyph* glyph, float* advance) {
  if (letter != kFailingLetter) return false;
  if (failure == Failure::Error) throw std::runtime_error("no letters today");
  if (failure == Failure::Memory) throw std::bad_alloc();
  if (advance != nullptr) *advance = 10.0f;
  if (glyph != nullptr) glyph->AdvanceX = 10.0f;
  return true;
}

/// Fails in whatever panel draws the letter, in the midst of it: where the browser draws letters for the page.
const ImFontLoader& failing_letters() {
  static const ImFontLoader loader = [] {
    ImFontLoader made;
    made.Name = "failing";
    made.FontSrcContainsGlyph = is_failing_letter;
    made.FontBakedLoadGlyph = fail_on_letter;
    return made;
  }();
  return loader;
}

class Faults : public testing::Test {
 protected:
  Faults() : stage_({}, R"({"welcomeSeen":true})", &failing_letters()) {}
  ~Faults() override { failure = Failure::None; }

  void open_with(Failure kind) {
    failure = kind;
    ASSERT_TRUE(stage_.open_text("names.bvh", small_bvh(5, "\xe5\x8f\xb3")).ok());
    stage_.settle();
  }

  AppStage stage_;
};

TEST_F(Faults, OfAPanelLeavesTheOthers) {
  open_with(Failure::Error);
  EXPECT_TRUE(stage_.shows("fault.outliner.retry"));
  EXPECT_FALSE(stage_.shows("outliner.joint.0"));
  for (const char* id : {"curves.canvas", "viewport.canvas", "play.toggle", "timeline.ruler", "file.save"}) {
    EXPECT_TRUE(stage_.shows(id)) << id;
  }
  ASSERT_EQ(stage_.log().faults.size(), 1u);
  EXPECT_NE(stage_.log().faults[0].find("no letters today"), std::string::npos);
  EXPECT_NE(stage_.log().announcements.back().find("The list of joints met with an error"), std::string::npos);
  stage_.click("play.toggle");
  EXPECT_TRUE(stage_.state()["playing"]);
  EXPECT_EQ(stage_.log().faults.size(), 1u);
}

TEST_F(Faults, OfAPanelIsTriedAgain) {
  open_with(Failure::Error);
  stage_.click("fault.outliner.copy");
  EXPECT_NE(std::string(ImGui::GetClipboardText()).find("no letters today"), std::string::npos);
  stage_.click("fault.outliner.retry");
  EXPECT_TRUE(stage_.shows("fault.outliner.retry"));
  EXPECT_EQ(stage_.log().faults.size(), 2u);
  failure = Failure::None;
  stage_.click("fault.outliner.retry");
  EXPECT_FALSE(stage_.shows("fault.outliner.retry"));
  EXPECT_TRUE(stage_.shows("outliner.joint.2"));
}

TEST_F(Faults, OfAPanelWithoutMemorySaysSo) {
  open_with(Failure::Memory);
  EXPECT_EQ(stage_.item("fault.outliner").label.rfind("There is not enough memory for the list of joints.", 0), 0u);
}

TEST_F(Faults, OfAWindowClosesIt) {
  open_with(Failure::None);
  failure = Failure::Error;
  // Letters that were drawn once are kept.
  for (ImFont* font : ImGui::GetIO().Fonts->Fonts) ImFontAtlasFontDiscardBakes(ImGui::GetIO().Fonts, font, 0);
  ASSERT_TRUE(stage_.app().run_command("help.commands", nullptr).is_null());
  for (int i = 0; i < 4; ++i) stage_.frame();  // until the search field has the keyboard
  stage_.type("\xe5\x8f\xb3");
  stage_.settle();
  EXPECT_EQ(stage_.state()["overlay"], "none");
  ASSERT_FALSE(stage_.state()["messages"].empty());
  EXPECT_EQ(stage_.state()["messages"][0]["title"], "The window could not be shown");
}

TEST_F(Faults, LeaveNothingOnTheStacksOfImGui) {
  open_with(Failure::None);
  const auto throw_amid = [] {
    ImGui::Begin("one", nullptr, ImGuiWindowFlags_None);
    ImGui::BeginChild("two");
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.5f);
    ImGui::PushStyleColor(ImGuiCol_Text, 0xff00ff00);
    ImGui::PushID("three");
    ImGui::BeginGroup();
    ImGui::BeginDisabled();
    ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);
    ImGui::PushFont(nullptr, 30.0f);
    ImGui::PushClipRect(ImVec2(0, 0), ImVec2(1, 1), true);
    ImGui::PushTextWrapPos(3.0f);
    if (ImGui::BeginTable("four", 2)) ImGui::TableNextColumn();
    throw std::runtime_error("amid");
  };
  ImGui::NewFrame();
  ImGuiErrorRecoveryState before;
  ImGui::ErrorRecoveryStoreState(&before);
  const std::optional<Fault> fault = draw_guarded(throw_amid);
  ImGuiErrorRecoveryState after;
  ImGui::ErrorRecoveryStoreState(&after);
  ImGui::EndFrame();
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->details, "amid");
  EXPECT_EQ(0, std::memcmp(&before, &after, sizeof before));
  stage_.settle();
  EXPECT_TRUE(stage_.shows("curves.canvas"));
}

TEST_F(Faults, AreLookedForWithoutAWindowOfImGuisOwn) {
  open_with(Failure::Error);
  const ImGuiWindow* behind_all = ImGui::FindWindowByName("Debug##Default");
  EXPECT_TRUE(behind_all == nullptr || !behind_all->WasActive);
}

TEST(FaultsOfCommands, AreToldAndGoNoFurther) {
  CommandRegistry registry;
  std::string told;
  registry.set_failed([&](const Command& command, const Fault& fault) { told = command.id + " " + fault.details; });
  registry.add({.id = "bad", .label = "Bad", .help = "", .run = [](const nlohmann::json&) -> nlohmann::json {
                  throw std::runtime_error("broken");
                }});
  registry.add({.id = "large", .label = "Large", .help = "", .run = [](const nlohmann::json&) -> nlohmann::json {
                  throw std::bad_alloc();
                }});
  EXPECT_EQ(registry.run("bad")["error"], "broken");
  EXPECT_EQ(told, "bad broken");
  EXPECT_NE(std::string(registry.run("large")["error"]).find("not enough memory"), std::string::npos);
}

TEST(FaultsOfChanges, WithoutMemoryAreErrors) {
  const Status status = with_memory_for("this change", []() -> Status { throw std::bad_alloc(); });
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, DiagnosticCode::OutOfMemory);
  EXPECT_EQ(status.error().message.rfind("There is not enough memory for this change.", 0), 0u);
  EXPECT_TRUE(with_memory_for("this change", [] { return Status{}; }));
}

}  // namespace
}  // namespace marey::app
