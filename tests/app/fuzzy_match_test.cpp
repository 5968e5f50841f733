#include "wasm/app/fuzzy_match.h"

#include <gtest/gtest.h>

namespace marey::app {
namespace {

int score(std::string_view query, std::string_view text) {
  const auto match = find_fuzzy_match(query, text);
  return match ? match->score : -1000;
}

TEST(FuzzyMatch, FindsLettersInTheirOrder) {
  EXPECT_TRUE(find_fuzzy_match("pn", "Play or pause in it"));
  EXPECT_TRUE(find_fuzzy_match("UNDO", "Undo"));
  EXPECT_FALSE(find_fuzzy_match("nu", "Un"));
  EXPECT_FALSE(find_fuzzy_match("undox", "Undo"));
}

TEST(FuzzyMatch, EmptyQueryMatchesEverything) {
  const auto match = find_fuzzy_match("  ", "Anything");
  ASSERT_TRUE(match);
  EXPECT_TRUE(match->positions.empty());
}

TEST(FuzzyMatch, PrefersStartsOfWordsAndWholeRuns) {
  EXPECT_GT(score("gg", "Ground grid"), score("gg", "Toggle"));
  EXPECT_GT(score("undo", "Undo"), score("undo", "Unload the door"));
  EXPECT_GT(score("dark", "Dark theme"), score("dark", "Add a marker"));
}

TEST(FuzzyMatch, ALetterThatStartsALaterWordDoesNotHideAMatch) {
  EXPECT_TRUE(find_fuzzy_match("cu", "Curves of c"));
  EXPECT_TRUE(find_fuzzy_match("abc", "ab b c abc"));
}

TEST(FuzzyMatch, PositionsAscendAndPointAtTheLetters) {
  const auto match = find_fuzzy_match("fra", "Last frame");
  ASSERT_TRUE(match);
  EXPECT_EQ(match->positions, (std::vector<int>{5, 6, 7}));
}

}  // namespace
}  // namespace marey::app
