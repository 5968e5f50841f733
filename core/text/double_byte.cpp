#include "core/text/double_byte.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/text/double_byte_tables.h"

namespace marey {
namespace {

constexpr unsigned kFirstIdeograph = 0x4e00;
constexpr unsigned kLastIdeograph = 0x9fa5;
/// In GBK/3 to GBK/5, from trail byte 40 on without 7F.
constexpr unsigned kGbk3Columns = 190;
constexpr unsigned kGbk4Columns = 96;
constexpr unsigned kGbk3Rows = 0x20;
constexpr unsigned kShiftJisColumns = 188;

/// The ideographs of GBK/3 and GBK/4: in the order of Unicode, those that GB/T 2312 lacks.
std::u16string make_gbk_ideographs() {
  constexpr std::size_t kFirstIdeographRow = 0xb0 - 0xa1;
  std::vector<bool> has(kLastIdeograph - kFirstIdeograph + 1);
  for (const std::u16string_view row : gb2312_rows().subspan(kFirstIdeographRow)) {
    for (const char16_t letter : row) {
      if (letter >= kFirstIdeograph && letter <= kLastIdeograph) has[letter - kFirstIdeograph] = true;
    }
  }
  std::u16string ideographs;
  for (unsigned letter = kFirstIdeograph; letter <= kLastIdeograph; ++letter) {
    if (!has[letter - kFirstIdeograph]) ideographs += static_cast<char16_t>(letter);
  }
  ideographs += gbk_compatibility_ideographs();
  return ideographs;
}

char32_t letter_in(std::u16string_view row, std::size_t column) {
  return column < row.size() && row[column] != kNoLetter ? row[column] : U'\0';
}

char32_t gbk_ideograph(std::size_t number) {
  static const std::u16string ideographs = make_gbk_ideographs();
  return letter_in(ideographs, number);
}

/// 40 is column 0; no column for 7F.
unsigned column_of(unsigned trail) { return trail - (trail > 0x7f ? 0x41 : 0x40); }

using Codes = std::vector<std::pair<char16_t, std::uint16_t>>;

/// Of letters with two codes the lowest that is not `avoided` comes first.
template <class LetterOf, class IsAvoided>
Codes make_codes(LetterOf letter_of, IsAvoided is_avoided) {
  Codes codes;
  for (unsigned code = 0x80; code < 0x10000; ++code) {
    const char32_t letter = letter_of(code);
    if (letter != 0 && !is_avoided(code)) codes.emplace_back(static_cast<char16_t>(letter), static_cast<std::uint16_t>(code));
  }
  std::sort(codes.begin(), codes.end());
  return codes;
}

unsigned find_code(const Codes& codes, char32_t letter) {
  if (letter > 0xffff) return 0;
  const auto found = std::lower_bound(codes.begin(), codes.end(), std::pair(static_cast<char16_t>(letter), std::uint16_t{0}));
  return found != codes.end() && found->first == letter ? found->second : 0;
}

}  // namespace

char32_t gbk_letter(unsigned code) {
  const unsigned lead = code >> 8;
  const unsigned trail = code & 0xff;
  if (lead == 0) return code == 0x80 ? U'€' : U'\0';
  if (lead < 0x81 || lead > 0xfe || trail < 0x40 || trail == 0x7f || trail > 0xfe) return 0;
  if (lead < 0xa1) return gbk_ideograph((lead - 0x81) * kGbk3Columns + column_of(trail));
  if (trail >= 0xa1) return lead <= 0xf7 ? letter_in(gb2312_rows()[lead - 0xa1], trail - 0xa1) : U'\0';
  if (lead >= 0xaa) return gbk_ideograph(kGbk3Rows * kGbk3Columns + (lead - 0xaa) * kGbk4Columns + column_of(trail));
  return lead >= 0xa8 ? letter_in(gbk_symbol_rows()[lead - 0xa8], column_of(trail)) : U'\0';
}

char32_t shift_jis_letter(unsigned code) {
  const unsigned lead = code >> 8;
  const unsigned trail = code & 0xff;
  if (lead == 0) return code >= 0xa1 && code <= 0xdf ? U'｡' + (code - 0xa1) : U'\0';
  const bool is_lead = (lead >= 0x81 && lead <= 0x9f) || (lead >= 0xe0 && lead <= 0xfc);
  if (!is_lead || trail < 0x40 || trail == 0x7f || trail > 0xfc) return 0;
  const unsigned number = (lead - (lead < 0xa0 ? 0x81 : 0xc1)) * kShiftJisColumns + column_of(trail);
  const std::size_t row = number / 94;
  return row < jis_rows().size() ? letter_in(jis_rows()[row], number % 94) : U'\0';
}

unsigned gbk_code(char32_t letter) {
  static const Codes codes = make_codes(gbk_letter, [](unsigned) { return false; });
  return find_code(codes, letter);
}

unsigned shift_jis_code(char32_t letter) {
  // IBM's additions stand in the rows of NEC once more.
  static const Codes codes = make_codes(shift_jis_letter, [](unsigned code) { return code >= 0xed00 && code < 0xef00; });
  return find_code(codes, letter);
}

}  // namespace marey
