#include "core/text/utf8.h"

#include <algorithm>
#include <array>

namespace marey {
namespace {

unsigned byte_at(std::string_view text, std::size_t at) { return static_cast<unsigned char>(text[at]); }

/// Bytes of a character by its first byte; 0 for a byte that begins none.
int length_of(unsigned first) {
  if (first < 0x80) return 1;
  if (first < 0xc2 || first > 0xf4) return 0;
  return first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
}

struct CapitalRange {
  char32_t first;
  char32_t last;
  char32_t distance;
};

char32_t small_letter(char32_t letter) {
  constexpr CapitalRange kCapitals[] = {{U'A', U'Z', 32}, {U'À', U'Ö', 32}, {U'Ø', U'Þ', 32}, {U'Α', U'Ϋ', 32},
                                        {U'Ѐ', U'Џ', 80}, {U'А', U'Я', 32}, {U'Ａ', U'Ｚ', 32}};
  for (const CapitalRange& range : kCapitals) {
    if (letter >= range.first && letter <= range.last) return letter + range.distance;
  }
  return letter;
}

}  // namespace

void append_utf8(char32_t code_point, std::string& out) {
  const auto add = [&out](char32_t byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (code_point < 0x80) {
    add(code_point);
  } else if (code_point < 0x800) {
    add(0xc0 | code_point >> 6);
    add(0x80 | (code_point & 0x3f));
  } else if (code_point < 0x10000) {
    add(0xe0 | code_point >> 12);
    add(0x80 | (code_point >> 6 & 0x3f));
    add(0x80 | (code_point & 0x3f));
  } else {
    add(0xf0 | code_point >> 18);
    add(0x80 | (code_point >> 12 & 0x3f));
    add(0x80 | (code_point >> 6 & 0x3f));
    add(0x80 | (code_point & 0x3f));
  }
}

std::optional<char32_t> take_utf8(std::string_view text, std::size_t& at) {
  constexpr std::array<char32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const unsigned first = byte_at(text, at);
  const int length = length_of(first);
  const std::size_t begin = at++;
  if (length == 0 || begin + static_cast<std::size_t>(length) > text.size()) return std::nullopt;
  char32_t code_point = length == 1 ? first : first & (0x7fU >> length);
  for (int i = 1; i < length; ++i) {
    const unsigned byte = byte_at(text, begin + static_cast<std::size_t>(i));
    if ((byte & 0xc0U) != 0x80U) return std::nullopt;
    code_point = code_point << 6 | (byte & 0x3fU);
  }
  const bool surrogate = code_point >= 0xd800 && code_point < 0xe000;
  if (code_point < kLeast[static_cast<std::size_t>(length)] || code_point > 0x10ffff || surrogate) return std::nullopt;
  at = begin + static_cast<std::size_t>(length);
  return code_point;
}

std::size_t count_letters(std::string_view utf8) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < utf8.size(); ++count) (void)take_utf8(utf8, at);
  return count;
}

std::string_view without_letters(std::string_view utf8, std::size_t count) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < count && at < utf8.size(); ++i) (void)take_utf8(utf8, at);
  return utf8.substr(at);
}

std::string in_small_letters(std::string_view utf8) {
  std::string text;
  for (std::size_t at = 0; at < utf8.size();) append_utf8(small_letter(take_utf8(utf8, at).value_or(kReplacement)), text);
  return text;
}

bool is_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    if (!take_utf8(text, at)) return false;
  }
  return true;
}

bool is_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

}  // namespace marey
