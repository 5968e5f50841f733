#pragma once

#include <string_view>
#include <vector>

#include "core/base/number_text.h"

namespace marey {

/// The number formats of the columns of `rows` (at least one row, all of one length), such that as many of the given
/// numbers as possible would be written as they stand. Fixed decimals per column if that explains the most, else one
/// form with as few digits as needed for all columns.
[[nodiscard]] std::vector<NumberFormat> guess_formats(const std::vector<std::vector<std::string_view>>& rows, char point);

/// The same for numbers that are all of one kind, such as the offsets. Canonical for an empty list.
[[nodiscard]] NumberFormat guess_format(const std::vector<std::string_view>& numbers, char point);

/// Digits behind the point of a number without an exponent; -1 with one.
[[nodiscard]] int count_decimals(std::string_view number, char point);

}  // namespace marey
