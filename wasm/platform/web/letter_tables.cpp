// The tables of core/text/double_byte_tables.h as the browser knows them: its TextDecoder follows the standard that they were
// taken from, and docs/decisions/character-sets.md says that no letter differs.
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/text/double_byte_tables.h"
#include "wasm/platform/web/host.h"

namespace marey {
namespace {

using Codes = std::vector<unsigned char>;  // lead and trail bytes in turn

/// Rows of letters that views look at; they stay where they are.
struct Rows {
  std::vector<std::u16string> letters;
  std::vector<std::u16string_view> views;
};

void add_code(unsigned lead, unsigned trail, Codes& codes) {
  codes.push_back(static_cast<unsigned char>(lead));
  codes.push_back(static_cast<unsigned char>(trail));
}

/// Rows of `columns` codes each; a row ends with its last letter.
Rows decode_rows(MareyLetters set, const Codes& codes, std::size_t columns) {
  std::u16string letters(codes.size() / 2, kNoLetter);
  marey_host_decode_letters(static_cast<int>(set), codes.data(), codes.size(), letters.data());
  Rows rows;
  for (std::size_t begin = 0; begin < letters.size(); begin += columns) {
    std::u16string row = letters.substr(begin, columns);
    for (char16_t& letter : row) letter = letter == 0 ? kNoLetter : letter;
    row.erase(row.find_last_not_of(kNoLetter) + 1);
    rows.letters.push_back(std::move(row));
  }
  rows.views.assign(rows.letters.begin(), rows.letters.end());
  return rows;
}

Rows decode_gb2312() {
  Codes codes;
  for (unsigned lead = 0xa1; lead <= 0xf7; ++lead) {
    for (unsigned trail = 0xa1; trail <= 0xfe; ++trail) add_code(lead, trail, codes);
  }
  return decode_rows(MareyLetters::Gbk, codes, 0xfe - 0xa1 + 1);
}

Rows decode_gbk_symbols() {
  Codes codes;
  for (unsigned lead = 0xa8; lead <= 0xa9; ++lead) {
    for (unsigned trail = 0x40; trail <= 0xa0; ++trail) {
      if (trail != 0x7f) add_code(lead, trail, codes);
    }
  }
  return decode_rows(MareyLetters::Gbk, codes, codes.size() / 4);
}

Rows decode_gbk_compatibility() {
  Codes codes;
  for (unsigned trail = 0x9c; trail <= 0xa0; ++trail) add_code(0xfd, trail, codes);
  for (unsigned trail = 0x40; trail <= 0x4f; ++trail) add_code(0xfe, trail, codes);
  return decode_rows(MareyLetters::Gbk, codes, codes.size() / 2);
}

Rows decode_jis() {
  Codes codes;
  for (unsigned lead = 0x81; lead <= 0xfc; ++lead) {
    if (lead >= 0xa0 && lead < 0xe0) continue;
    for (unsigned trail = 0x40; trail <= 0xfc; ++trail) {
      if (trail != 0x7f) add_code(lead, trail, codes);
    }
  }
  return decode_rows(MareyLetters::ShiftJis, codes, 94);
}

}  // namespace

std::span<const std::u16string_view> gb2312_rows() {
  static const Rows rows = decode_gb2312();
  return rows.views;
}

std::span<const std::u16string_view> gbk_symbol_rows() {
  static const Rows rows = decode_gbk_symbols();
  return rows.views;
}

std::u16string_view gbk_compatibility_ideographs() {
  static const Rows rows = decode_gbk_compatibility();
  return rows.views.front();
}

std::span<const std::u16string_view> jis_rows() {
  static const Rows rows = decode_jis();
  return rows.views;
}

}  // namespace marey
