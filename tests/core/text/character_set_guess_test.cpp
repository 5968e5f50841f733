#include "core/text/character_set_guess.h"

#include <gtest/gtest.h>

#include "tests/core/text/names.h"

namespace marey {
namespace {

CharacterSet guess(const std::vector<std::string>& names) {
  const std::vector<std::string_view> views(names.begin(), names.end());
  return guess_character_set(views);
}

std::vector<std::string> all_in(CharacterSet set, const std::vector<std::string>& names) {
  std::vector<std::string> bytes;
  for (const std::string& name : names) bytes.push_back(test::bytes_in(set, name));
  return bytes;
}

TEST(CharacterSetGuess, FindsTheSetOfEveryLanguage) {
  for (const auto& [language, set, names] : test::names_of_languages()) {
    EXPECT_EQ(traits_of(guess(all_in(set, names))).id, traits_of(set).id) << language;
  }
}

TEST(CharacterSetGuess, KeepsUtf8WhateverTheLanguage) {
  for (const auto& [language, set, names] : test::names_of_languages()) {
    EXPECT_EQ(guess(names), CharacterSet::Utf8) << language;
  }
  EXPECT_EQ(guess({"Hips", "LeftUpLeg", "mixamorig:Spine", ""}), CharacterSet::Utf8);
  EXPECT_EQ(guess({}), CharacterSet::Utf8);
}

// Some exporters cut names at a number of bytes.
TEST(CharacterSetGuess, ForgivesACutNameAmongUtf8) {
  EXPECT_EQ(guess({"Таз", "Поясница", "Левое плечо", "Правая рука", "Голова", "Левая стопа дли\xD0"}), CharacterSet::Utf8);
  EXPECT_EQ(guess({"左手", "右手", "頭", "上半身", "左\xE6\x89"}), CharacterSet::Utf8);
}

TEST(CharacterSetGuess, TakesNoOrderOfTheNamesIntoAccount) {
  for (const auto& [language, set, names] : test::names_of_languages()) {
    const std::vector<std::string> bytes = all_in(set, names);
    EXPECT_EQ(guess({bytes.rbegin(), bytes.rend()}), guess(bytes)) << language;
  }
}

// Each name by itself has to do as well as it can: a wrong guess of a whole file needs many that mislead.
TEST(CharacterSetGuess, MostNamesSpeakForThemselves) {
  int right = 0;
  int all = 0;
  for (const auto& [language, set, names] : test::names_of_languages()) {
    for (const std::string& bytes : all_in(set, names)) {
      if (guess({bytes}) == CharacterSet::Utf8) continue;
      ++all;
      right += guess({bytes}) == set ? 1 : 0;
    }
  }
  EXPECT_GE(right * 100, all * 80) << right << " of " << all;
  RecordProperty("right", right);
  RecordProperty("all", all);
}

TEST(CharacterSetGuess, CountsBitsSoThatCommonLettersAreCheap) {
  EXPECT_LT(cost_in("\xCE", CharacterSet::Windows1251), cost_in("\xDA", CharacterSet::Windows1251));
  EXPECT_LT(cost_in("\xD7\xF3", CharacterSet::Gbk), cost_in("\xF7\xC5", CharacterSet::Gbk));
  EXPECT_GT(cost_in("\xFF", CharacterSet::Gbk), 30.0);
  EXPECT_DOUBLE_EQ(cost_in("Hips", CharacterSet::Gbk), cost_in("Hips", CharacterSet::Windows1252));
}

}  // namespace
}  // namespace marey
