#include "wasm/app/shortcut.h"

#include <gtest/gtest.h>

namespace marey::app {
namespace {

TEST(Shortcut, ReadsKeysWithModifiers) {
  EXPECT_EQ(parse_chord("Z"), ImGuiKey_Z);
  EXPECT_EQ(parse_chord("Ctrl+Shift+Z"), ImGuiMod_Ctrl | ImGuiMod_Shift | ImGuiKey_Z);
  EXPECT_EQ(parse_chord(" Space "), ImGuiKey_Space);
  EXPECT_EQ(parse_chord("Alt+Left"), ImGuiMod_Alt | ImGuiKey_LeftArrow);
  EXPECT_EQ(parse_chord("5"), ImGuiKey_5);
  EXPECT_EQ(parse_chord("["), ImGuiKey_LeftBracket);
}

TEST(Shortcut, QuestionMarkIsShiftAndSlash) { EXPECT_EQ(parse_chord("?"), ImGuiMod_Shift | ImGuiKey_Slash); }

TEST(Shortcut, RefusesWhatItDoesNotKnow) {
  EXPECT_FALSE(parse_chord("Hyper+X"));
  EXPECT_FALSE(parse_chord("Ctrl+"));
  EXPECT_FALSE(parse_chord(""));
  EXPECT_FALSE(parse_chord("Spacebar"));
}

TEST(Shortcut, ListsSeveralChords) {
  const auto chords = parse_shortcuts("Ctrl+Shift+Z, Ctrl+Y");
  ASSERT_EQ(chords.size(), 2u);
  EXPECT_EQ(chords[1], ImGuiMod_Ctrl | ImGuiKey_Y);
  EXPECT_TRUE(parse_shortcuts("").empty());
}

TEST(Shortcut, ShowsTheFirstChordAsPeopleReadIt) {
  EXPECT_EQ(displayed_shortcut("Ctrl+Shift+Z, Ctrl+Y", false), "Ctrl Shift Z");
  EXPECT_EQ(displayed_shortcut("Ctrl+Z", true), "⌘ Z");
  EXPECT_EQ(displayed_shortcut("Shift+Left", false), "Shift ←");
  EXPECT_EQ(displayed_shortcut("Period", false), ".");
  EXPECT_EQ(displayed_shortcut("", false), "");
}

}  // namespace
}  // namespace marey::app
