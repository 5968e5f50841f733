#include "core/text/character_set.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/text/double_byte.h"
#include "core/text/single_byte.h"
#include "core/text/utf8.h"

namespace marey {
namespace {

constexpr std::array<CharacterSetTraits, kCharacterSets.size()> kTraits = {{
    {CharacterSet::Utf8, "utf-8", "UTF-8", "all scripts"},
    {CharacterSet::Windows1251, "windows-1251", "Windows-1251", "Cyrillic"},
    {CharacterSet::Windows1252, "windows-1252", "Windows-1252", "Western"},
    {CharacterSet::Gbk, "gbk", "GBK", "Chinese"},
    {CharacterSet::ShiftJis, "shift_jis", "Shift-JIS", "Japanese"},
}};

unsigned byte_at(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes[at]); }

DecodedLetter single(char32_t code_point) {
  return {code_point == 0 ? std::nullopt : std::optional(code_point), 1};
}

DecodedLetter utf8_letter_at(std::string_view bytes, std::size_t at) {
  std::size_t end = at;
  const auto code_point = take_utf8(bytes, end);
  return {code_point, end - at};
}

DecodedLetter double_byte_letter_at(std::string_view bytes, std::size_t at, CharacterSet set) {
  const bool is_gbk = set == CharacterSet::Gbk;
  const unsigned lead = byte_at(bytes, at);
  if (const char32_t alone = is_gbk ? gbk_letter(lead) : shift_jis_letter(lead); alone != 0) return single(alone);
  if (at + 1 == bytes.size()) return {};
  const unsigned code = lead << 8 | byte_at(bytes, at + 1);
  const char32_t letter = is_gbk ? gbk_letter(code) : shift_jis_letter(code);
  if (letter == 0) return {};
  return {letter, 2};
}

/// 0 where the set has no such letter.
unsigned code_of(char32_t letter, CharacterSet set) {
  switch (set) {
    case CharacterSet::Utf8: break;
    case CharacterSet::Windows1251: return windows_1251_code(letter);
    case CharacterSet::Windows1252: return windows_1252_code(letter);
    case CharacterSet::Gbk: return gbk_code(letter);
    case CharacterSet::ShiftJis: return shift_jis_code(letter);
  }
  return 0;
}

Error cannot_encode(std::string_view letter, CharacterSet set) {
  const std::string_view label = traits_of(set).label;
  return {DiagnosticCode::InvalidArgument, {}, fmt::format("{} has no letter '{}'.", label, letter), std::string(label),
          std::string(letter)};
}

}  // namespace

const CharacterSetTraits& traits_of(CharacterSet set) { return kTraits[static_cast<std::size_t>(set)]; }

std::optional<CharacterSet> find_character_set(std::string_view id) {
  const auto found = std::find_if(kTraits.begin(), kTraits.end(), [id](const auto& traits) { return traits.id == id; });
  return found == kTraits.end() ? std::nullopt : std::optional(found->set);
}

DecodedLetter letter_at(std::string_view bytes, std::size_t at, CharacterSet set) {
  const unsigned byte = byte_at(bytes, at);
  if (byte < 0x80) return single(byte);
  switch (set) {
    case CharacterSet::Utf8: return utf8_letter_at(bytes, at);
    case CharacterSet::Windows1251: return single(windows_1251_letter(byte));
    case CharacterSet::Windows1252: return single(windows_1252_letter(byte));
    case CharacterSet::Gbk:
    case CharacterSet::ShiftJis: return double_byte_letter_at(bytes, at, set);
  }
  return {};
}

std::string decoded(std::string_view bytes, CharacterSet set) {
  std::string text;
  text.reserve(bytes.size());
  for (std::size_t at = 0; at < bytes.size();) {
    const DecodedLetter letter = letter_at(bytes, at, set);
    append_utf8(letter.code_point.value_or(kReplacement), text);
    at += letter.length;
  }
  return text;
}

Result<std::string> encoded(std::string_view utf8, CharacterSet set) {
  std::string bytes;
  for (std::size_t at = 0; at < utf8.size();) {
    const std::size_t begin = at;
    const auto letter = take_utf8(utf8, at);
    const std::string_view text = utf8.substr(begin, at - begin);
    if (!letter || *letter == 0) return cannot_encode(text, set);
    if (*letter < 0x80 || set == CharacterSet::Utf8) {
      bytes += text;
      continue;
    }
    const unsigned code = code_of(*letter, set);
    if (code == 0) return cannot_encode(text, set);
    if (code > 0xff) bytes += static_cast<char>(static_cast<unsigned char>(code >> 8));
    bytes += static_cast<char>(static_cast<unsigned char>(code & 0xff));
  }
  return bytes;
}

}  // namespace marey
