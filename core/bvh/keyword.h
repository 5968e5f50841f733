#pragma once

#include <cstdint>
#include <string_view>

namespace marey {

enum class Keyword : std::uint8_t { None, Hierarchy, Root, Joint, End, Offset, Channels, Motion, Frames, Frame };

/// The keyword at the start of `word`, in any case. "Frames:3" and "Frames:" are Frames; "EndSite" is End.
[[nodiscard]] Keyword find_keyword(std::string_view word);

/// As the format writes it: "HIERARCHY", "End", "Frames" ...; "" for None.
[[nodiscard]] std::string_view keyword_text(Keyword keyword);

}  // namespace marey
