#include "core/base/text_cursor.h"

#include <gtest/gtest.h>

#include <string>

namespace marey {
namespace {

TEST(PlaceFinder, CountsEachKindOfLineEndOnce) {
  const std::string text = "a\nbb\r\ncc\rdd\n\ne";
  PlaceFinder places(text);
  EXPECT_EQ(places.place_of(0), (TextPlace{1, 1}));
  EXPECT_EQ(places.place_of(text.find("bb")), (TextPlace{2, 1}));
  EXPECT_EQ(places.place_of(text.find("bb") + 1), (TextPlace{2, 2}));
  EXPECT_EQ(places.place_of(text.find("cc")), (TextPlace{3, 1}));
  EXPECT_EQ(places.place_of(text.find("dd")), (TextPlace{4, 1}));
  EXPECT_EQ(places.place_of(text.find('e')), (TextPlace{6, 1}));
  EXPECT_EQ(places.place_of(text.size()), (TextPlace{6, 2}));
}

TEST(PlaceFinder, GivesTheSamePlacesInAnyOrder) {
  const std::string text = "one\r\ntwo\n\nthree\rfour five\n";
  for (std::size_t first = 0; first <= text.size(); ++first) {
    for (std::size_t second = 0; second <= text.size(); ++second) {
      PlaceFinder reused(text);
      PlaceFinder fresh(text);
      (void)reused.place_of(first);
      ASSERT_EQ(reused.place_of(second), fresh.place_of(second)) << first << " then " << second;
    }
  }
}

TEST(TextCursor, TakesWordsUpToBlanksAndBraces) {
  TextCursor cursor("  JOINT{ a}b", 0);
  cursor.skip_blanks();
  EXPECT_EQ(cursor.take_word(), "JOINT");
  EXPECT_EQ(cursor.take_word(), "{");
  cursor.skip_blanks();
  EXPECT_EQ(cursor.peek_word(), "a");
  EXPECT_EQ(cursor.take_word(), "a");
  EXPECT_EQ(cursor.take_word(), "}");
  EXPECT_EQ(cursor.take_word(), "b");
  EXPECT_TRUE(cursor.at_end());
  EXPECT_EQ(cursor.take_word(), "");
}

TEST(Shown, CutsLongTextsAndHidesControlBytes) {
  EXPECT_EQ(shown("Hips"), "Hips");
  EXPECT_EQ(shown(std::string("a\0b\n", 4)), "a?b?");
  EXPECT_EQ(shown(std::string(50, 'x')), std::string(40, 'x') + "...");
}

}  // namespace
}  // namespace marey
