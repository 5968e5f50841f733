#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace marey {

enum class NameLetters : std::uint8_t {
  Ascii,  ///< letters, digits, '_', '-', '.' and ':'
  Words,  ///< letters, digits and '_'
};

/// A name in the given letters: Cyrillic and accented Latin letters become their Latin ones ("Плечо" is "Plecho",
/// "Mão" is "Mao"), other ASCII characters '_'. `is_complete` is set to false when there are letters that have no
/// Latin ones; they are left out. May be empty.
[[nodiscard]] std::string ascii_name(std::string_view utf8_name, NameLetters letters, bool& is_complete);

}  // namespace marey
