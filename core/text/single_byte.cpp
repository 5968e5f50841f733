#include "core/text/single_byte.h"

#include <cstddef>
#include <string_view>

namespace marey {
namespace {

constexpr char16_t kNone = u'\u25af';

/// Bytes 80 to BF; Cyrillic А to я fill the rest.
constexpr std::u16string_view kWindows1251 =
    u"ЂЃ‚ѓ„…†‡€‰Љ‹ЊЌЋЏ"
    u"ђ‘’“”•–—▯™љ›њќћџ"
    u"\u00a0ЎўЈ¤Ґ¦§Ё©Є«¬\u00ad®Ї"
    u"°±Ііґµ¶·ё№є»јЅѕї";
/// Bytes 80 to 9F; from A0 on it is Latin-1.
constexpr std::u16string_view kWindows1252 =
    u"€▯‚ƒ„…†‡ˆ‰Š‹Œ▯Ž▯"
    u"▯‘’“”•–—˜™š›œ▯žŸ";
static_assert(kWindows1251.size() == 64 && kWindows1252.size() == 32);

char32_t letter_in(std::u16string_view table, unsigned byte) {
  const char16_t letter = table[byte - 0x80];
  return letter == kNone ? U'\0' : letter;
}

unsigned code_in(std::u16string_view table, char32_t letter) {
  if (letter > 0xffff || letter == kNone) return 0;
  const std::size_t at = table.find(static_cast<char16_t>(letter));
  return at == std::u16string_view::npos ? 0 : static_cast<unsigned>(at) + 0x80;
}

}  // namespace

char32_t windows_1251_letter(unsigned byte) {
  return byte >= 0xc0 ? U'А' + (byte - 0xc0) : letter_in(kWindows1251, byte);
}

char32_t windows_1252_letter(unsigned byte) { return byte >= 0xa0 ? byte : letter_in(kWindows1252, byte); }

unsigned windows_1251_code(char32_t letter) {
  if (letter >= U'А' && letter <= U'я') return static_cast<unsigned>(letter - U'А') + 0xc0;
  return code_in(kWindows1251, letter);
}

unsigned windows_1252_code(char32_t letter) {
  if (letter >= 0xa0 && letter <= 0xff) return static_cast<unsigned>(letter);
  return code_in(kWindows1252, letter);
}

}  // namespace marey
