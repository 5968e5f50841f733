#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace marey {

/// Stands for what is no character.
inline constexpr char32_t kReplacement = 0xfffd;

/// Precondition: a code point, so at most 10FFFF.
void append_utf8(char32_t code_point, std::string& out);

/// The code point whose UTF-8 begins at `at`, which moves behind it. Nothing, and one byte passed, where the bytes are
/// no UTF-8: overlong forms, surrogates and cut sequences are none. Precondition: at < text.size().
[[nodiscard]] std::optional<char32_t> take_utf8(std::string_view text, std::size_t& at);

/// Of valid UTF-8.
[[nodiscard]] std::size_t count_letters(std::string_view utf8);
/// Valid UTF-8 without its first `count` letters.
[[nodiscard]] std::string_view without_letters(std::string_view utf8, std::size_t count);
/// Valid UTF-8 in small letters: Latin, Greek and Cyrillic as far as they have them at a fixed distance. For searching.
[[nodiscard]] std::string in_small_letters(std::string_view utf8);

[[nodiscard]] bool is_utf8(std::string_view text);
[[nodiscard]] bool is_ascii(std::string_view text);

}  // namespace marey
