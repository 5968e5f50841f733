#pragma once

#include <cstddef>
#include <string_view>

#include "core/base/text_cursor.h"

namespace marey {

/// How numbers are told apart in the rows of one file.
struct NumberLook {
  char point = '.';             ///< ',' when decimal commas are the habit of the file
  bool commas_separate = false;      ///< a comma or semicolon between numbers counts as a blank
  bool semicolons_separate = false;  ///< a semicolon alone does, beside decimal commas
};

/// True for what may stand between two numbers.
[[nodiscard]] inline bool is_separator(char c, const NumberLook& look) {
  return is_blank(c) || (c == ';' && (look.commas_separate || look.semicolons_separate)) || (c == ',' && look.commas_separate);
}

/// True if a number ends before text[at] because the sign of the next one stands there ("0.0-7.509").
[[nodiscard]] inline bool runs_together(std::string_view text, std::size_t at) {
  return at > 0 && (text[at] == '-' || text[at] == '+') && (is_digit(text[at - 1]) || text[at - 1] == '.');
}

/// Length of the value (or of a word in its place) at the start of `text`, which is no separator.
[[nodiscard]] std::size_t value_length(std::string_view text, const NumberLook& look);

/// Counts the values of `line` outside of comments.
[[nodiscard]] int count_values(std::string_view line, const NumberLook& look);

/// The text up to the next line end.
[[nodiscard]] std::string_view first_line(std::string_view text);
/// The text behind its first line end, of which CRLF is one.
[[nodiscard]] std::string_view behind_first_line(std::string_view text);

/// Length of the separators at the start of `text`.
[[nodiscard]] std::size_t gap_length(std::string_view text, const NumberLook& look);

[[nodiscard]] bool has_line_end(std::string_view gap);

/// Length of the comment at the start of `text`, 0 if there is none: "#", "//" or ";" to the end of the line, "/*" to
/// the next "*/" or, without one in the next 1024 bytes, to the end of the line.
[[nodiscard]] std::size_t comment_length(std::string_view text);

[[nodiscard]] bool starts_comment(std::string_view text);

}  // namespace marey
