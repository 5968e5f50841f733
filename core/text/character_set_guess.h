#pragma once

#include <span>
#include <string_view>

#include "core/text/character_set.h"

namespace marey {

/// The character set in which the names of one file make the most sense. UTF-8 if all of them are UTF-8, as plain ASCII
/// is. Else the set in which it takes the fewest bits to write them down, by a simple model of how people write:
/// a letter costs the less the more common it is (Russian by letter; first-level ideographs of GB/T 2312 and JIS less
/// than others; kana less than ideographs; the accented letters of Western languages less than signs), bytes that stand
/// for no letter cost most, and so does what people seldom write: capitals behind small letters and single letters in
/// Cyrillic, scripts that change within a word, many accented letters in a row. Of equal costs the set that comes first
/// in CharacterSet wins. A few short names can mislead it.
[[nodiscard]] CharacterSet guess_character_set(std::span<const std::string_view> names);

/// Bits that the model takes for one name; for tests.
[[nodiscard]] double cost_in(std::string_view name, CharacterSet set);

}  // namespace marey
