#include "wasm/platform/dom_keys.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace marey::app {
namespace {

TEST(DomKeys, LettersFollowTheLayout) {
  EXPECT_EQ(find_key("KeyQ", "q"), ImGuiKey_Q);
  EXPECT_EQ(find_key("KeyQ", "a"), ImGuiKey_A) << "French layout";
  EXPECT_EQ(find_key("KeyY", "Z"), ImGuiKey_Z) << "German layout, with Shift";
}

TEST(DomKeys, LettersOfOtherScriptsFollowThePlace) {
  EXPECT_EQ(find_key("KeyZ", "\u044f"), ImGuiKey_Z) << "Russian";
  EXPECT_EQ(find_key("KeyS", "\u00df"), ImGuiKey_S) << "Option on a Mac";
}

TEST(DomKeys, DigitsKeepTheirKeyWithShift) {
  EXPECT_EQ(find_key("Digit1", "1"), ImGuiKey_1);
  EXPECT_EQ(find_key("Digit1", "!"), ImGuiKey_1);
  EXPECT_EQ(find_key("Digit1", "&"), ImGuiKey_1) << "French layout";
}

TEST(DomKeys, TheNumberPadHasKeysOfItsOwn) {
  EXPECT_EQ(find_key("Numpad7", "7"), ImGuiKey_Keypad7);
  EXPECT_EQ(find_key("Numpad7", "Home"), ImGuiKey_Keypad7);
  EXPECT_EQ(find_key("NumpadEnter", "Enter"), ImGuiKey_KeypadEnter);
}

TEST(DomKeys, NamedKeysFollowThePlace) {
  EXPECT_EQ(find_key("Space", " "), ImGuiKey_Space);
  EXPECT_EQ(find_key("ArrowLeft", "ArrowLeft"), ImGuiKey_LeftArrow);
  EXPECT_EQ(find_key("Slash", "?"), ImGuiKey_Slash);
  EXPECT_EQ(find_key("F10", "F10"), ImGuiKey_F10);
  EXPECT_EQ(find_key("F1", "F1"), ImGuiKey_F1);
}

TEST(DomKeys, UnknownKeysAreNone) {
  for (const char* code : {"", "Key", "KeyÄ", "Digit", "Numpad", "F", "F13x", "Zz", "AAA", "MediaPlayPause"}) {
    EXPECT_EQ(find_key(code, "Unidentified"), ImGuiKey_None) << code;
  }
}

TEST(DomKeys, LettersHaveKeysOfTheirOwn) {
  std::set<ImGuiKey> keys;
  for (char letter = 'a'; letter <= 'z'; ++letter) keys.insert(find_key("", std::string(1, letter)));
  EXPECT_EQ(keys.size(), 26u);
  EXPECT_FALSE(keys.contains(ImGuiKey_None));
}

}  // namespace
}  // namespace marey::app
