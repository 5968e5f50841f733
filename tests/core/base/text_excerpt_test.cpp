#include "core/base/text_excerpt.h"

#include <gtest/gtest.h>

#include <array>

namespace marey {
namespace {

TextExcerpt excerpt_of(std::string_view text, TextPlace place) {
  const std::array places = {place};
  return make_excerpts(text, places)[0];
}

TEST(TextExcerpt, ShowsTheLineWithItsNeighbours) {
  const TextExcerpt excerpt = excerpt_of("one\r\ntwo\rthree\nfour\n", {3, 4});
  EXPECT_EQ(excerpt.first_line, 2);
  EXPECT_EQ(excerpt.lines, (std::vector<std::string>{"two", "three", "four"}));
  EXPECT_EQ(excerpt.marked_line, 1);
  EXPECT_EQ(excerpt.marked_byte, 3);
}

TEST(TextExcerpt, EndsWithTheText) {
  const TextExcerpt first = excerpt_of("one\ntwo", {1, 1});
  EXPECT_EQ(first.lines, (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(first.marked_line, 0);
  const TextExcerpt last = excerpt_of("one\ntwo", {2, 99});
  EXPECT_EQ(last.marked_line, 1);
  EXPECT_EQ(last.marked_byte, 3);
  const TextExcerpt behind = excerpt_of("one\n", {2, 1});
  EXPECT_EQ(behind.lines, (std::vector<std::string>{"one", ""}));
  EXPECT_EQ(behind.marked_line, 1);
}

TEST(TextExcerpt, HasNoLinesForAPlaceOutsideOfTheText) {
  EXPECT_TRUE(excerpt_of("one\n", {5, 1}).lines.empty());
  EXPECT_TRUE(excerpt_of("one\n", {0, 0}).lines.empty());
}

TEST(TextExcerpt, CutsLongLinesAroundThePlaceAndBetweenLetters) {
  std::string line;
  for (int i = 0; i < 200; ++i) line += "ж";
  const TextExcerpt excerpt = excerpt_of("short\n" + line + "\nshort", {2, 202});
  ASSERT_EQ(excerpt.lines.size(), 3u);
  EXPECT_LE(excerpt.lines[1].size(), TextExcerpt::kMostBytes);
  EXPECT_EQ(excerpt.lines[1].substr(0, 2), "ж");
  EXPECT_GT(excerpt.marked_byte, 40);
  EXPECT_EQ(excerpt.lines[0], "");
}

TEST(TextExcerpt, KeepsTheOrderOfThePlaces) {
  const std::array places = {TextPlace{3, 1}, TextPlace{1, 1}, TextPlace{3, 2}};
  const std::vector<TextExcerpt> excerpts = make_excerpts("a\nb\nc", places);
  ASSERT_EQ(excerpts.size(), 3u);
  EXPECT_EQ(excerpts[0].lines.back(), "c");
  EXPECT_EQ(excerpts[1].lines.front(), "a");
  EXPECT_EQ(excerpts[2].marked_byte, 1);
}

}  // namespace
}  // namespace marey
