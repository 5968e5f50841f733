#include "core/interchange/ascii_name.h"

#include <cstddef>

namespace marey {
namespace {

struct Spelling {
  std::string_view letter;  // in UTF-8
  std::string_view latin;
};

constexpr Spelling kSpellings[] = {
    {"а", "a"}, {"А", "A"}, {"б", "b"}, {"Б", "B"}, {"в", "v"}, {"В", "V"}, {"г", "g"}, {"Г", "G"}, {"д", "d"},
    {"Д", "D"}, {"е", "e"}, {"Е", "E"}, {"ё", "e"}, {"Ё", "E"}, {"ж", "zh"}, {"Ж", "Zh"}, {"з", "z"}, {"З", "Z"},
    {"и", "i"}, {"И", "I"}, {"й", "y"}, {"Й", "Y"}, {"к", "k"}, {"К", "K"}, {"л", "l"}, {"Л", "L"}, {"м", "m"},
    {"М", "M"}, {"н", "n"}, {"Н", "N"}, {"о", "o"}, {"О", "O"}, {"п", "p"}, {"П", "P"}, {"р", "r"}, {"Р", "R"},
    {"с", "s"}, {"С", "S"}, {"т", "t"}, {"Т", "T"}, {"у", "u"}, {"У", "U"}, {"ф", "f"}, {"Ф", "F"}, {"х", "kh"},
    {"Х", "Kh"}, {"ц", "ts"}, {"Ц", "Ts"}, {"ч", "ch"}, {"Ч", "Ch"}, {"ш", "sh"}, {"Ш", "Sh"}, {"щ", "shch"},
    {"Щ", "Shch"}, {"ъ", ""}, {"Ъ", ""}, {"ы", "y"}, {"Ы", "Y"}, {"ь", ""}, {"Ь", ""}, {"э", "e"}, {"Э", "E"},
    {"ю", "yu"}, {"Ю", "Yu"}, {"я", "ya"}, {"Я", "Ya"}, {"є", "ye"}, {"Є", "Ye"}, {"і", "i"}, {"І", "I"},
    {"ї", "yi"}, {"Ї", "Yi"}, {"ґ", "g"}, {"Ґ", "G"}, {"ў", "u"}, {"Ў", "U"},
    {"À", "A"}, {"Á", "A"}, {"Â", "A"}, {"Ã", "A"}, {"Ä", "A"}, {"Å", "A"}, {"Æ", "Ae"}, {"Ç", "C"}, {"È", "E"},
    {"É", "E"}, {"Ê", "E"}, {"Ë", "E"}, {"Ì", "I"}, {"Í", "I"}, {"Î", "I"}, {"Ï", "I"}, {"Ð", "D"}, {"Ñ", "N"},
    {"Ò", "O"}, {"Ó", "O"}, {"Ô", "O"}, {"Õ", "O"}, {"Ö", "O"}, {"Ø", "O"}, {"Ù", "U"}, {"Ú", "U"}, {"Û", "U"},
    {"Ü", "U"}, {"Ý", "Y"}, {"Þ", "Th"}, {"ß", "ss"}, {"à", "a"}, {"á", "a"}, {"â", "a"}, {"ã", "a"}, {"ä", "a"},
    {"å", "a"}, {"æ", "ae"}, {"ç", "c"}, {"è", "e"}, {"é", "e"}, {"ê", "e"}, {"ë", "e"}, {"ì", "i"}, {"í", "i"},
    {"î", "i"}, {"ï", "i"}, {"ð", "d"}, {"ñ", "n"}, {"ò", "o"}, {"ó", "o"}, {"ô", "o"}, {"õ", "o"}, {"ö", "o"},
    {"ø", "o"}, {"ù", "u"}, {"ú", "u"}, {"û", "u"}, {"ü", "u"}, {"ý", "y"}, {"þ", "th"}, {"ÿ", "y"}, {"Ā", "A"},
    {"ā", "a"}, {"Ă", "A"}, {"ă", "a"}, {"Ą", "A"}, {"ą", "a"}, {"Ć", "C"}, {"ć", "c"}, {"Ĉ", "C"}, {"ĉ", "c"},
    {"Ċ", "C"}, {"ċ", "c"}, {"Č", "C"}, {"č", "c"}, {"Ď", "D"}, {"ď", "d"}, {"Đ", "D"}, {"đ", "d"}, {"Ē", "E"},
    {"ē", "e"}, {"Ĕ", "E"}, {"ĕ", "e"}, {"Ė", "E"}, {"ė", "e"}, {"Ę", "E"}, {"ę", "e"}, {"Ě", "E"}, {"ě", "e"},
    {"Ĝ", "G"}, {"ĝ", "g"}, {"Ğ", "G"}, {"ğ", "g"}, {"Ġ", "G"}, {"ġ", "g"}, {"Ģ", "G"}, {"ģ", "g"}, {"Ĥ", "H"},
    {"ĥ", "h"}, {"Ĩ", "I"}, {"ĩ", "i"}, {"Ī", "I"}, {"ī", "i"}, {"Ĭ", "I"}, {"ĭ", "i"}, {"Į", "I"}, {"į", "i"},
    {"İ", "I"}, {"ı", "i"}, {"Ĵ", "J"}, {"ĵ", "j"}, {"Ķ", "K"}, {"ķ", "k"}, {"Ĺ", "L"}, {"ĺ", "l"}, {"Ļ", "L"},
    {"ļ", "l"}, {"Ľ", "L"}, {"ľ", "l"}, {"Ł", "L"}, {"ł", "l"}, {"Ń", "N"}, {"ń", "n"}, {"Ņ", "N"}, {"ņ", "n"},
    {"Ň", "N"}, {"ň", "n"}, {"Ō", "O"}, {"ō", "o"}, {"Ŏ", "O"}, {"ŏ", "o"}, {"Ő", "O"}, {"ő", "o"}, {"Œ", "Oe"},
    {"œ", "oe"}, {"Ŕ", "R"}, {"ŕ", "r"}, {"Ŗ", "R"}, {"ŗ", "r"}, {"Ř", "R"}, {"ř", "r"}, {"Ś", "S"}, {"ś", "s"},
    {"Ŝ", "S"}, {"ŝ", "s"}, {"Ş", "S"}, {"ş", "s"}, {"Š", "S"}, {"š", "s"}, {"Ţ", "T"}, {"ţ", "t"}, {"Ť", "T"},
    {"ť", "t"}, {"Ũ", "U"}, {"ũ", "u"}, {"Ū", "U"}, {"ū", "u"}, {"Ŭ", "U"}, {"ŭ", "u"}, {"Ů", "U"}, {"ů", "u"},
    {"Ű", "U"}, {"ű", "u"}, {"Ų", "U"}, {"ų", "u"}, {"Ŵ", "W"}, {"ŵ", "w"}, {"Ŷ", "Y"}, {"ŷ", "y"}, {"Ÿ", "Y"},
    {"Ź", "Z"}, {"ź", "z"}, {"Ż", "Z"}, {"ż", "z"}, {"Ž", "Z"}, {"ž", "z"},
};

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; }

/// The bytes of the character at the start of `text`; one byte where it is not UTF-8. `text` is not empty.
std::string_view first_character(std::string_view text) {
  std::size_t length = 1;
  while (length < text.size() && length < 4 && is_continuation(text[length])) ++length;
  return text.substr(0, static_cast<unsigned char>(text[0]) < 0x80U ? 1 : length);
}

bool is_plain(char c, NameLetters letters) {
  const bool is_word = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  return is_word || (letters == NameLetters::Ascii && (c == '-' || c == '.' || c == ':'));
}

}  // namespace

std::string ascii_name(std::string_view utf8_name, NameLetters letters, bool& is_complete) {
  std::string name;
  is_complete = true;
  while (!utf8_name.empty()) {
    const std::string_view character = first_character(utf8_name);
    utf8_name.remove_prefix(character.size());
    if (static_cast<unsigned char>(character[0]) < 0x80U) {
      name += is_plain(character[0], letters) ? character[0] : '_';
      continue;
    }
    bool is_known = false;
    for (const Spelling& spelling : kSpellings) {
      if (spelling.letter != character) continue;
      name += spelling.latin;
      is_known = true;
    }
    is_complete = is_complete && is_known;
  }
  return name;
}

}  // namespace marey
