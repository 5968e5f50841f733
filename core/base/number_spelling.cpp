#include "core/base/number_spelling.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "core/base/index.h"

namespace marey {
namespace {

/// Decimal numbers of up to 15 digits are told apart by their doubles, so digits without surplus zeros are the shortest.
constexpr int kDistinctDigits = 15;

double power_of_ten(int exponent) {
  const double power = kExactPowersOfTen[idx(std::abs(exponent))];
  return exponent < 0 ? 1.0 / power : power;
}

bool all_digits(std::string_view text) { return std::all_of(text.begin(), text.end(), is_digit); }

/// "d.ddd" of a number with an exponent: one digit, not 0, and no zero at the end.
bool is_shortest_mantissa(std::string_view text, char point) {
  if (text.empty() || !is_digit(text[0]) || text[0] == '0' || size_of(text) > kDistinctDigits + 1) return false;
  if (text.size() == 1) return true;
  return text.size() > 2 && text[1] == point && all_digits(text.substr(2)) && text.back() != '0';
}

/// True only for what the format certainly writes with an exponent.
bool is_usual_exponent_form(std::string_view text, const NumberFormat& format) {
  constexpr int kFarFromDenormals = 290;
  if (!text.empty() && text.front() == '-') text.remove_prefix(1);
  const std::size_t letter = text.find(format.exponent_letter);
  if (letter == std::string_view::npos || letter + 2 >= text.size()) return false;
  if (!is_shortest_mantissa(text.substr(0, letter), format.point)) return false;
  const char sign = text[letter + 1];
  const std::string_view digits = text.substr(letter + 2);
  if ((sign != '-' && sign != '+') || !all_digits(digits) || digits.size() > 4) return false;
  const int wanted_digits = format.exponent_digits;
  if (size_of(digits) < wanted_digits || (size_of(digits) > wanted_digits && digits.front() == '0')) return false;
  int exponent = 0;
  for (const char digit : digits) exponent = exponent * 10 + (digit - '0');
  if (exponent > kFarFromDenormals) return false;
  if (sign == '-') return exponent > 0 && -exponent < format.exponent_below;
  return exponent >= format.exponent_from;
}

}  // namespace

PlainSpelling::PlainSpelling(const NumberFormat& format)
    : unique_below_(std::uint64_t{1} << 51),
      decimals_(format.decimals),
      shortest_(format.form == NumberFormat::Form::Shortest),
      smallest_(power_of_ten(format.exponent_below)),
      end_(power_of_ten(format.exponent_from)) {
  if (shortest_) unique_below_ = 1'000'000'000'000'000;
  if (!format.leading_zero) unique_below_ = 0;
}

bool is_spelled_as(std::string_view text, double value, const NumberFormat& format) {
  if (format.form == NumberFormat::Form::Shortest && is_usual_exponent_form(text, format)) return true;
  std::string written;
  append_number(value, format, written);
  return written == text;
}

}  // namespace marey
