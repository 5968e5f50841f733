#include "core/text/utf8.h"

#include <gtest/gtest.h>

namespace marey {
namespace {

TEST(Utf8, ReadsWhatItWrites) {
  for (char32_t letter = 1; letter <= 0x10ffff; letter += letter < 0x900 ? 1 : 61) {
    if (letter >= 0xd800 && letter < 0xe000) continue;
    std::string text;
    append_utf8(letter, text);
    std::size_t at = 0;
    ASSERT_EQ(take_utf8(text, at), letter);
    ASSERT_EQ(at, text.size());
  }
}

TEST(Utf8, RefusesOverlongFormsSurrogatesAndWhatIsCut) {
  for (const char* text : {"\xC0\x80", "\xC1\xBF", "\xE0\x80\x80", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xF0\x80\x80\x80",
                           "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\x80", "\xE4\xB8", "\xE4\xB8z", "\xFF"}) {
    std::size_t at = 0;
    EXPECT_EQ(take_utf8(text, at), std::nullopt) << text;
    EXPECT_EQ(at, 1u);
    EXPECT_FALSE(is_utf8(text));
  }
  EXPECT_TRUE(is_utf8("Hips Голова 頭 😀"));
  EXPECT_TRUE(is_utf8(""));
}

TEST(Utf8, CountsLettersNotBytes) {
  EXPECT_EQ(count_letters("a頭я"), 3u);
  EXPECT_EQ(without_letters("a頭я", 2), "я");
  EXPECT_EQ(without_letters("a頭я", 9), "");
}

TEST(Utf8, FindsSmallLettersOfSeveralScripts) {
  EXPECT_EQ(in_small_letters("LeftARM Ärmel ГОЛОВА Ёж Ѝ Ωμ 頭 ÷×"), "leftarm ärmel голова ёж ѝ ωμ 頭 ÷×");
}

TEST(Utf8, KnowsAscii) {
  EXPECT_TRUE(is_ascii("Hips:LeftArm_01"));
  EXPECT_FALSE(is_ascii("Hüfte"));
}

}  // namespace
}  // namespace marey
