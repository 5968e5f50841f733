#pragma once

#include <cstddef>
#include <string_view>

namespace marey {

// What string_view::find_first_of() and find_last_of() do, at the rate of the memory: blocks without what is sought are passed by SIMD.

/// The first place from `from` on where `a` or `b` stands; npos if there is none.
[[nodiscard]] std::size_t find_either(std::string_view text, char a, char b, std::size_t from = 0);

/// The first byte from `from` on that is not ASCII; npos if there is none.
[[nodiscard]] std::size_t find_beyond_ascii(std::string_view text, std::size_t from = 0);

/// The last place where CR or LF stands; npos if there is none.
[[nodiscard]] std::size_t find_last_line_end(std::string_view text);

/// The line ends that stop in text[from, to): CR, LF and CRLF each are one. `to` may lie within a CRLF, which then counts
/// behind it.
[[nodiscard]] std::size_t count_line_ends(std::string_view text, std::size_t from, std::size_t to);

}  // namespace marey
