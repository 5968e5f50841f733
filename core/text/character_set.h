#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace marey {

/// What letters the bytes of a file's names stand for; BVH does not say. Each holds ASCII as it is.
enum class CharacterSet : std::uint8_t {
  Utf8,
  Windows1251,  ///< Cyrillic
  Windows1252,  ///< Western; contains the letters of Latin-1
  Gbk,          ///< simplified and traditional Chinese, as Windows code page 936
  ShiftJis,     ///< Japanese, as Windows code page 932
};

inline constexpr std::array kCharacterSets = {CharacterSet::Utf8, CharacterSet::Windows1251, CharacterSet::Windows1252,
                                              CharacterSet::Gbk, CharacterSet::ShiftJis};

struct CharacterSetTraits {
  CharacterSet set{};
  std::string_view id;     ///< for programs, the label of the WHATWG Encoding Standard: "windows-1251"
  std::string_view label;  ///< for people: "Windows-1251"
  std::string_view script; ///< for people: "Cyrillic"
};

[[nodiscard]] const CharacterSetTraits& traits_of(CharacterSet set);

/// The set with this id; nothing if there is none.
[[nodiscard]] std::optional<CharacterSet> find_character_set(std::string_view id);

/// One letter of a text in some set.
struct DecodedLetter {
  std::optional<char32_t> code_point;  ///< nothing: these bytes stand for no letter
  std::size_t length = 1;              ///< bytes
};

/// The letter that begins at `at`. What stands for no letter is one byte long, so that ASCII behind it is not lost.
/// Precondition: at < bytes.size().
[[nodiscard]] DecodedLetter letter_at(std::string_view bytes, std::size_t at, CharacterSet set);

/// `bytes` as valid UTF-8, for showing them; U+FFFD for each byte that stands for no letter, and for NUL. The same on
/// every machine.
[[nodiscard]] std::string decoded(std::string_view bytes, CharacterSet set);

/// UTF-8 in the bytes of `set`; decoded() gives the same text back. Error InvalidArgument: `utf8` has a letter that the
/// set lacks, or is not UTF-8. Of a letter with two codes (code page 932 has some 400) it takes the one that Windows
/// takes.
[[nodiscard]] Result<std::string> encoded(std::string_view utf8, CharacterSet set);

}  // namespace marey
