#include "core/text/character_set_guess.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/text/utf8.h"

namespace marey {
namespace {

// Bits. Those of letters are -log2 of a share; the others were chosen so that bone names in five languages come out right.
constexpr double kAscii = 5.0;
constexpr double kSign = 14.0;
constexpr double kNoLetterAtAll = 40.0;
constexpr double kScriptChange = 2.0;

bool is_ascii_letter(char32_t letter) { return (letter >= U'a' && letter <= U'z') || (letter >= U'A' && letter <= U'Z'); }
bool is_ideograph(char32_t letter) { return letter >= 0x4e00 && letter <= 0x9fff; }
bool is_kana(char32_t letter) { return letter >= 0x3041 && letter <= 0x30fe; }
bool is_half_width_kana(char32_t letter) { return letter >= 0xff66 && letter <= 0xff9f; }
bool is_full_width_ascii(char32_t letter) { return letter >= 0xff01 && letter <= 0xff5e; }

/// А to я, with Ё, І, Ї, Є, Ґ and Ў.
bool is_cyrillic(char32_t letter) {
  constexpr std::u32string_view kOthers = U"ЁёІіЇїЄєҐґЎў";
  return (letter >= U'А' && letter <= U'я') || kOthers.find(letter) != std::u32string_view::npos;
}
bool is_cyrillic_capital(char32_t letter) {
  constexpr std::u32string_view kOthers = U"ЁІЇЄҐЎ";
  return (letter >= U'А' && letter <= U'Я') || kOthers.find(letter) != std::u32string_view::npos;
}

/// A letter with the bytes it was read from and the one before it; 0 at the start.
struct LetterInName {
  char32_t letter = 0;
  unsigned code = 0;
  char32_t before = 0;
  char32_t after = 0;
  int accents_before = 0;  ///< letters beyond ASCII in a row
};

double russian_letter_cost(char32_t letter) {
  // Of а to я, by their shares in the Russian National Corpus: о 11.0 %, е 8.5 %, а 8.0 % ... ъ 0.04 %.
  constexpr std::array<double, 32> kCosts = {3.6, 6.0, 4.5, 5.9, 5.1, 3.6, 6.7, 5.9, 3.8, 6.4, 4.8, 4.5, 5.0, 3.9, 3.2, 5.2,
                                             4.4, 4.2, 4.0, 5.2, 8.6, 6.7, 7.7, 6.1, 7.1, 8.1, 11.3, 5.7, 5.8, 8.3, 7.3, 5.6};
  constexpr double kUkrainian = 7.0;
  const char32_t small = letter >= U'А' && letter <= U'Я' ? letter + (U'а' - U'А') : letter;
  return small >= U'а' && small <= U'я' ? kCosts[small - U'а'] : kUkrainian;
}

double cyrillic_cost(const LetterInName& at) {
  constexpr double kOddCapital = 8.0;
  constexpr double kCapitalInARow = 1.0;
  constexpr double kAlone = 4.0;
  constexpr double kBesideLatin = 4.0;
  if (!is_cyrillic(at.letter)) return kSign;
  double cost = russian_letter_cost(at.letter);
  if (is_cyrillic_capital(at.letter) && is_cyrillic(at.before)) {
    cost += is_cyrillic_capital(at.before) ? kCapitalInARow : kOddCapital;
  }
  if (!is_cyrillic(at.before) && !is_cyrillic(at.after)) cost += kAlone;
  cost += kBesideLatin * ((is_ascii_letter(at.before) ? 1 : 0) + (is_ascii_letter(at.after) ? 1 : 0));
  return cost;
}

double western_cost(const LetterInName& at) {
  constexpr std::u32string_view kCommon = U"àáâãäåæçèéêëíîïñóôõöøúûüß";
  constexpr double kCommonCost = 6.0;
  constexpr double kCapitalCost = 8.0;
  constexpr double kOtherCost = 10.0;
  constexpr double kInARow = 6.0;
  constexpr int kUsualRow = 2;
  if (at.letter < 0xc0 || at.letter > 0xff || at.letter == U'×' || at.letter == U'÷') return kSign;
  const double in_a_row = at.accents_before >= kUsualRow ? kInARow : 0.0;
  if (kCommon.find(at.letter) != std::u32string_view::npos) return kCommonCost + in_a_row;
  const bool common_capital = at.letter < 0xdf && kCommon.find(at.letter + 0x20) != std::u32string_view::npos;
  return (common_capital ? kCapitalCost : kOtherCost) + in_a_row;
}

double script_change_cost(const LetterInName& at) {
  return kScriptChange * ((is_ascii_letter(at.before) ? 1 : 0) + (is_ascii_letter(at.after) ? 1 : 0));
}

double chinese_cost(const LetterInName& at) {
  constexpr double kFirstLevel = 11.0;
  constexpr double kSecondLevel = 16.0;
  constexpr double kOfGbkOnly = 18.0;
  if (is_full_width_ascii(at.letter)) return 12.0;
  if (!is_ideograph(at.letter)) return kSecondLevel;
  const bool in_gb2312 = (at.code & 0xff) >= 0xa1;
  const double cost = !in_gb2312 ? kOfGbkOnly : at.code < 0xd800 ? kFirstLevel : kSecondLevel;
  return cost + script_change_cost(at);
}

double japanese_cost(const LetterInName& at) {
  constexpr double kKana = 7.0;
  constexpr double kHalfWidthKana = 6.5;
  constexpr double kCommonHalfWidthKana = 4.5;
  constexpr double kFirstLevel = 12.0;
  constexpr double kSecondLevel = 17.0;
  constexpr double kAlone = 6.0;
  if (is_kana(at.letter)) return kKana + script_change_cost(at);
  if (is_half_width_kana(at.letter)) {
    const bool alone = !is_half_width_kana(at.before) && !is_half_width_kana(at.after);
    const bool common = at.letter == U'ﾞ' || at.letter == U'ﾝ' || at.letter == U'ｰ';
    return (common ? kCommonHalfWidthKana : kHalfWidthKana) + (alone ? kAlone : 0.0) + script_change_cost(at);
  }
  if (is_full_width_ascii(at.letter)) return 10.0;
  if (!is_ideograph(at.letter)) return kSecondLevel;
  return (at.code < 0x989f ? kFirstLevel : kSecondLevel) + script_change_cost(at);
}

double utf8_cost(const LetterInName& at) { return at.letter < 0x800 ? 10.0 : kSign; }

double letter_cost(const LetterInName& at, CharacterSet set) {
  if (at.letter < 0x80) return kAscii;
  switch (set) {
    case CharacterSet::Utf8: return utf8_cost(at);
    case CharacterSet::Windows1251: return cyrillic_cost(at);
    case CharacterSet::Windows1252: return western_cost(at);
    case CharacterSet::Gbk: return chinese_cost(at);
    case CharacterSet::ShiftJis: return japanese_cost(at);
  }
  return kNoLetterAtAll;
}

unsigned code_at(std::string_view name, std::size_t at, std::size_t length) {
  unsigned code = 0;
  for (const char c : name.substr(at, length)) code = code << 8 | static_cast<unsigned char>(c);
  return code;
}

}  // namespace

double cost_in(std::string_view name, CharacterSet set) {
  double cost = 0.0;
  LetterInName at;
  for (std::size_t offset = 0; offset < name.size();) {
    const DecodedLetter letter = letter_at(name, offset, set);
    const std::size_t next = offset + letter.length;
    at.letter = letter.code_point.value_or(0);
    at.code = code_at(name, offset, letter.length);
    at.after = next < name.size() ? letter_at(name, next, set).code_point.value_or(0) : 0;
    const bool is_one = letter.code_point.has_value();
    cost += is_one ? letter_cost(at, set) : kNoLetterAtAll;
    at.accents_before = is_one && at.letter >= 0x80 ? at.accents_before + 1 : 0;
    at.before = at.letter;
    offset = next;
  }
  return cost;
}

CharacterSet guess_character_set(std::span<const std::string_view> names) {
  if (std::all_of(names.begin(), names.end(), is_utf8)) return CharacterSet::Utf8;
  CharacterSet best = CharacterSet::Utf8;
  double least = std::numeric_limits<double>::infinity();
  for (const CharacterSet set : kCharacterSets) {
    double cost = 0.0;
    for (const std::string_view name : names) cost += is_ascii(name) ? 0.0 : cost_in(name, set);
    if (cost >= least) continue;
    best = set;
    least = cost;
  }
  return best;
}

}  // namespace marey
