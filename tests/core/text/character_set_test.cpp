#include "core/text/character_set.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "core/text/utf8.h"
#include "tests/core/text/names.h"

namespace marey {
namespace {

std::string bytes_of(unsigned code) {
  std::string bytes;
  if (code > 0xff) bytes += static_cast<char>(static_cast<unsigned char>(code >> 8));
  bytes += static_cast<char>(static_cast<unsigned char>(code & 0xff));
  return bytes;
}

/// The letter of a code of one or two bytes, 0 if all of its bytes are not one letter.
char32_t letter_of(unsigned code, CharacterSet set) {
  const std::string bytes = bytes_of(code);
  const DecodedLetter letter = letter_at(bytes, 0, set);
  return letter.length == bytes.size() ? letter.code_point.value_or(0) : 0;
}

/// Number of two-byte letters and FNV-1a over all of them.
std::pair<int, std::uint64_t> fingerprint(CharacterSet set) {
  int count = 0;
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (unsigned code = 0; code < 0x10000; ++code) {
    const char32_t letter = code > 0xff ? letter_of(code, set) : 0;
    count += letter != 0 ? 1 : 0;
    for (const unsigned byte : {static_cast<unsigned>(letter & 0xff), static_cast<unsigned>(letter >> 8)}) {
      hash = (hash ^ byte) * 0x100000001b3ULL;
    }
  }
  return {count, hash};
}

// The numbers are those of the tables as the WHATWG Encoding Standard has them, without private use; Python's codecs
// gbk and cp932 give the same.
TEST(CharacterSet, HasTheLettersOfTheCodePagesNativelyAndInWebAssembly) {
  EXPECT_EQ(fingerprint(CharacterSet::Gbk), std::pair(21791, std::uint64_t{0x8ae38714cbc1c915}));
  EXPECT_EQ(fingerprint(CharacterSet::ShiftJis), std::pair(7724, std::uint64_t{0xb3f96b97d30330a0}));
}

TEST(CharacterSet, KnowsLettersByTheirBytes) {
  EXPECT_EQ(decoded("\xD0\xF3\xEA\xE0 \xB8\xA8", CharacterSet::Windows1251), "Рука ёЁ");
  EXPECT_EQ(decoded("F\xFC\xDF" "e \x80", CharacterSet::Windows1252), "Füße €");
  EXPECT_EQ(decoded("\xD7\xF3\xCA\xD6L", CharacterSet::Gbk), "左手L");
  EXPECT_EQ(decoded("\x81\x40\xFD\x9B\xFE\x4F\xA8\x40\x80", CharacterSet::Gbk), "丂龥\uFA29ˊ€");
  EXPECT_EQ(decoded("\x8D\xB6\x8E\xE8\x83\x7B\xC3\xDE", CharacterSet::ShiftJis), "左手ボﾃﾞ");
  EXPECT_EQ(decoded("\x87\x40\xFB\xFC\xFC\x4B\xED\x40", CharacterSet::ShiftJis), "①髙黑纊");
}

TEST(CharacterSet, ShowsWhatStandsForNoLetterAndLosesNothingBehindIt) {
  EXPECT_EQ(decoded("a\x98z", CharacterSet::Windows1251), "a\uFFFDz");
  EXPECT_EQ(decoded("a\x81z", CharacterSet::Windows1252), "a\uFFFDz");
  EXPECT_EQ(decoded("a\xFF" "A\xD7", CharacterSet::Gbk), "a\uFFFDA\uFFFD");
  EXPECT_EQ(decoded("\xD7 x", CharacterSet::Gbk), "\uFFFD x");
  EXPECT_EQ(decoded("\x83{\x83", CharacterSet::ShiftJis), "ボ\uFFFD");
  EXPECT_EQ(decoded("\xF0\x40", CharacterSet::ShiftJis), "\uFFFD@");
  EXPECT_EQ(decoded("Knie\xD0", CharacterSet::Utf8), "Knie\uFFFD");
  EXPECT_EQ(decoded(std::string("a\0b", 3), CharacterSet::Gbk), "a\uFFFDb");
}

TEST(CharacterSet, GivesValidUtf8ForAnyBytes) {
  for (const CharacterSet set : kCharacterSets) {
    for (unsigned code = 0; code < 0x10000; ++code) {
      ASSERT_TRUE(is_utf8(decoded(bytes_of(code) + "x", set))) << traits_of(set).id << " " << code;
    }
  }
}

TEST(CharacterSet, GivesTheBytesBack) {
  for (const CharacterSet set : kCharacterSets) {
    int other_bytes = 0;
    for (unsigned code = 1; code < 0x10000; ++code) {
      if (letter_of(code, set) == 0) continue;
      const std::string text = decoded(bytes_of(code), set);
      const Result<std::string> bytes = encoded(text, set);
      ASSERT_TRUE(bytes) << traits_of(set).id << " " << code;
      other_bytes += *bytes != bytes_of(code) ? 1 : 0;
      ASSERT_EQ(decoded(*bytes, set), text);
    }
    // Code page 932 has 398 letters of NEC and IBM twice or thrice.
    EXPECT_EQ(other_bytes, set == CharacterSet::ShiftJis ? 398 : 0) << traits_of(set).id;
  }
}

TEST(CharacterSet, TakesTheCodeThatWindowsTakes) {
  EXPECT_EQ(*encoded("ⅰ", CharacterSet::ShiftJis), "\xFA\x40");
  EXPECT_EQ(*encoded("Ⅰ", CharacterSet::ShiftJis), "\x87\x54");
  EXPECT_EQ(*encoded("￢", CharacterSet::ShiftJis), "\x81\xCA");
}

TEST(CharacterSet, RefusesLettersThatItLacks) {
  const Result<std::string> refused = encoded("Рука", CharacterSet::Windows1252);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, DiagnosticCode::InvalidArgument);
  EXPECT_EQ(refused.error().message, "Windows-1252 has no letter 'Р'.");
  EXPECT_FALSE(encoded("한", CharacterSet::ShiftJis));
  EXPECT_FALSE(encoded("▯", CharacterSet::Windows1251));
  EXPECT_FALSE(encoded("▯", CharacterSet::Gbk));
  EXPECT_FALSE(encoded("😀", CharacterSet::Gbk));
  EXPECT_FALSE(encoded("\xD0", CharacterSet::Utf8));
  EXPECT_EQ(*encoded("😀 한", CharacterSet::Utf8), "😀 한");
}

TEST(CharacterSet, KeepsNamesOfEveryLanguage) {
  for (const auto& [language, set, names] : test::names_of_languages()) {
    for (const std::string& name : names) EXPECT_EQ(decoded(test::bytes_in(set, name), set), name) << language;
  }
}

TEST(CharacterSet, IsFoundByItsId) {
  for (const CharacterSet set : kCharacterSets) EXPECT_EQ(find_character_set(traits_of(set).id), set);
  EXPECT_EQ(find_character_set("latin-9"), std::nullopt);
}

}  // namespace
}  // namespace marey
