#pragma once

#include <cstdint>
#include <string_view>

namespace marey {

enum class Keyword : std::uint8_t { None, Hierarchy, Root, Joint, End, Offset, Channels, Motion, Frames, Frame };

/// The keyword at the start of `word`, in any case. "Frames:3" and "Frames:" are Frames; "EndSite" and "End_Site" are
/// End; "JOINT:", "OFFSET-1" and "CHANNELS3" are what they begin with.
[[nodiscard]] Keyword find_keyword(std::string_view word);

/// The keyword of the hierarchy, or MOTION, that `word` misses by one letter ("CHANELS", "HEIRARCHY"); None otherwise.
[[nodiscard]] Keyword find_misspelled_keyword(std::string_view word);

/// As the format writes it: "HIERARCHY", "End", "Frames" ...; "" for None.
[[nodiscard]] std::string_view keyword_text(Keyword keyword);

/// True for ':', '=' and ';', which some files have behind a keyword.
[[nodiscard]] constexpr bool is_keyword_punctuation(char c) { return c == ':' || c == '=' || c == ';'; }

}  // namespace marey
