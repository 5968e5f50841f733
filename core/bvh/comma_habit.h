#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/bvh/row_text.h"

namespace marey {

/// The first `most` lines of `rows`, within its first MiB, that hold values: lines that begin with a number, and those
/// that begin with a word in place of one. Ends at a line of text.
[[nodiscard]] std::vector<std::string_view> find_value_lines(std::string_view rows, int channel_count, int most);

/// Decides what commas and semicolons mean in `rows`, which begins with the first sample, by many lines together:
/// - decimal signs, if more numbers have a comma within than a point, and the values then fit the channels at least as
///   well as with commas as blanks;
/// - decimal signs, and semicolons blanks, if both stand in the rows and points do not: "1,5;2,5";
/// - blanks, if they stand where no decimal sign can;
/// - nothing otherwise: numbers with a comma are then no numbers.
/// `first_lines` are find_value_lines().
[[nodiscard]] NumberLook find_comma_habit(std::string_view rows, const std::vector<std::string_view>& first_lines,
                                          int channel_count, std::optional<std::int64_t> declared_frames);

/// Values in all lines, and how many lines hold some.
struct RowCensus {
  std::int64_t lines = 0;
  std::int64_t values = 0;
};
[[nodiscard]] RowCensus take_census(std::string_view rows, const NumberLook& look);

}  // namespace marey
