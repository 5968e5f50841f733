#include <gtest/gtest.h>

#include "tests/app/support/app_stage.h"

namespace marey::app {
namespace {

/// "Рука" in Windows-1251, and in UTF-8.
const std::string kArm = "\xD0\xF3\xEA\xE0";
constexpr const char* kArmInUtf8 = "Рука";

class Names : public testing::Test {
 protected:
  void open(const std::string& text) {
    ASSERT_TRUE(stage_.open_text("names.bvh", text).ok());
    stage_.app().run_command("view.problems", nullptr);
    stage_.settle();
  }
  std::string tip() { return stage_.state()["joints"][2]["name"]; }

  AppStage stage_;
};

TEST_F(Names, AreShownAsLettersEverywhere) {
  open(small_bvh(3, kArm));
  EXPECT_EQ(stage_.state()["namesIn"], "windows-1251");
  EXPECT_EQ(tip(), kArmInUtf8);
  EXPECT_EQ(stage_.item("outliner.joint.2").label, kArmInUtf8);
  EXPECT_EQ(stage_.app().run_command("select.joint", {{"joint", 2}}), kArmInUtf8);
  EXPECT_EQ(stage_.app().save_text(), small_bvh(3, kArm));
}

TEST_F(Names, InAnotherSetAreOneClickAwayAndUndoable) {
  open(small_bvh(3, kArm));
  EXPECT_EQ(stage_.item("inspector.names_in.windows-1251").label, kArmInUtf8);
  EXPECT_EQ(stage_.item("inspector.names_in.gbk").label, "畜赅");
  stage_.click("clip.names_in.gbk@inspector");
  EXPECT_EQ(stage_.state()["namesIn"], "gbk");
  EXPECT_EQ(tip(), "畜赅");
  EXPECT_EQ(stage_.state()["undoName"], "Read names as GBK");
  stage_.settle();
  EXPECT_EQ(stage_.item("outliner.joint.2").label, "畜赅");
  stage_.app().run_command("edit.undo", nullptr);
  EXPECT_EQ(stage_.state()["namesIn"], "windows-1251");
  EXPECT_EQ(tip(), kArmInUtf8);
}

TEST_F(Names, OfPlainAsciiLeaveNothingToChoose) {
  open(small_bvh());
  EXPECT_FALSE(stage_.shows("clip.names_in.gbk@inspector"));
  EXPECT_TRUE(stage_.app().run_command("clip.names_in.gbk", nullptr).contains("error"));
  EXPECT_EQ(stage_.state()["namesIn"], "utf-8");
}

TEST_F(Names, AreFoundWhateverTheirCase) {
  open(small_bvh(3, kArm));
  stage_.click("outliner.search");
  stage_.type("рУк");
  stage_.settle();
  EXPECT_TRUE(stage_.shows("outliner.joint.2"));
  stage_.type("x");
  stage_.settle();
  EXPECT_FALSE(stage_.shows("outliner.joint.2"));
}

TEST_F(Names, ShowInTheTextOfAFinding) {
  std::string text = small_bvh(3, kArm);
  open(text.replace(text.find("JOINT " + kArm), 5, "joint"));
  const nlohmann::json list = stage_.state()["diagnostics"];
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i]["code"] != "keyword_case") continue;
    stage_.click("problems.entry." + std::to_string(i));
    const std::string line = stage_.item("problems.excerpt." + std::to_string(i)).label;
    EXPECT_EQ(line.substr(line.find("joint")), std::string("joint ") + kArmInUtf8);
    return;
  }
  ADD_FAILURE() << "no keyword_case in " << list;
}

std::string in_utf16(const std::string& ascii) {
  std::string bytes = "\xFF\xFE";
  for (const char c : ascii) bytes.append(1, c).append(1, '\0');
  return bytes;
}

TEST_F(Names, TheTextOfAUtf16FileIsShownToo) {
  std::string text = small_bvh();
  open(in_utf16(text.replace(text.find("JOINT"), 5, "joint")));
  const nlohmann::json list = stage_.state()["diagnostics"];
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i]["code"] != "keyword_case") continue;
    stage_.click("problems.entry." + std::to_string(i));
    const std::string line = stage_.item("problems.excerpt." + std::to_string(i)).label;
    EXPECT_EQ(line.substr(line.find("joint")), "joint Middle");
    return;
  }
  ADD_FAILURE() << "no keyword_case in " << list;
}

}  // namespace
}  // namespace marey::app
