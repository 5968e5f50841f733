#include "core/base/number_text.h"

#include <fast_float/fast_float.h>
#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/index.h"
#include "core/base/plain_number.h"
#include "core/base/text_cursor.h"

namespace marey {
namespace {

/// The parts of a number in a text; all positions are bytes from its start.
struct NumberParts {
  std::size_t length = 0;  ///< 0: no number
  bool negative = false;
  bool has_plus = false;
  std::uint64_t mantissa = 0;
  int significant_digits = 0;  ///< of mantissa, leading zeros not counted; more than 19 make it useless
  std::int64_t exponent = 0;
};

std::size_t take_mantissa_digits(std::string_view text, std::size_t at, NumberParts& parts) {
  const std::size_t begin = at;
  for (; at < text.size() && is_digit(text[at]); ++at) {
    parts.mantissa = parts.mantissa * 10 + static_cast<std::uint64_t>(text[at] - '0');
    if (parts.significant_digits > 0 || text[at] != '0') ++parts.significant_digits;
  }
  return at - begin;
}

/// Length of an exponent at `at`, 0 if there is none; an 'e' without digits is not part of the number.
std::size_t take_exponent(std::string_view text, std::size_t at, NumberParts& parts) {
  constexpr std::int64_t kBeyondAnyDouble = 1'000'000;
  const std::size_t begin = at;
  if (at >= text.size() || (text[at] != 'e' && text[at] != 'E')) return 0;
  ++at;
  const bool negative = at < text.size() && text[at] == '-';
  if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
  if (at >= text.size() || !is_digit(text[at])) return 0;
  std::int64_t exponent = 0;
  for (; at < text.size() && is_digit(text[at]); ++at) {
    exponent = std::min(exponent * 10 + (text[at] - '0'), kBeyondAnyDouble);
  }
  parts.exponent += negative ? -exponent : exponent;
  return at - begin;
}

NumberParts split_number(std::string_view text, char point) {
  NumberParts parts;
  std::size_t at = 0;
  parts.negative = !text.empty() && text[0] == '-';
  parts.has_plus = !text.empty() && text[0] == '+';
  if (parts.negative || parts.has_plus) ++at;
  const std::size_t integer_digits = take_mantissa_digits(text, at, parts);
  at += integer_digits;
  std::size_t decimals = 0;
  if (at < text.size() && text[at] == point) {
    decimals = take_mantissa_digits(text, at + 1, parts);
    if (integer_digits + decimals > 0) at += 1 + decimals;
  }
  if (integer_digits + decimals == 0) return parts;
  parts.exponent = -static_cast<std::int64_t>(decimals);
  parts.length = at + take_exponent(text, at, parts);
  return parts;
}

double read_by_library(std::string_view number, char point) {
  double value = 0.0;
  if (point == '.') {
    fast_float::from_chars(number.data(), number.data() + number.size(), value);
    return value;
  }
  std::string with_point(number);
  std::replace(with_point.begin(), with_point.end(), point, '.');
  return read_by_library(with_point, '.');
}

std::string_view point_or_nothing(const NumberFormat& format) {
  return format.point == ',' ? std::string_view(",") : std::string_view(".");
}

/// Digits `whole` and `decimals` with the point of the format between them.
void append_positional(std::string_view whole, std::string_view decimals, const NumberFormat& format, std::string& out) {
  const bool bare = whole.empty() || whole == "0";
  if (!bare) out += whole;
  if (bare && (format.leading_zero || decimals.empty())) out += '0';
  if (!decimals.empty()) out.append(point_or_nothing(format)).append(decimals);
}

/// The fast and usual case: `magnitude` is an integer of less than 2^51 over an exact power of ten. Then that integer
/// is the only one which reads back as these bits, so its digits are what a file with so many decimals said.
bool append_exact_fixed(double magnitude, const NumberFormat& format, std::string& out) {
  constexpr double kUniqueBelow = 2251799813685248.0;  // 2^51
  if (format.decimals >= kExactPowersOfTen.size()) return false;
  const double power = kExactPowersOfTen[format.decimals];
  const double scaled = magnitude * power;
  if (!(scaled < kUniqueBelow)) return false;
  const auto integer = static_cast<std::uint64_t>(scaled + 0.5);
  if (static_cast<double>(integer) / power != magnitude) return false;
  const fmt::format_int text(integer);
  std::string_view digits(text.data(), text.size());
  char padded[48];
  if (digits.size() <= format.decimals) {
    const std::size_t zeros = format.decimals + std::size_t{1} - digits.size();
    std::fill_n(padded, zeros, '0');
    std::copy(digits.begin(), digits.end(), padded + zeros);
    digits = {padded, zeros + digits.size()};
  }
  const std::size_t whole = digits.size() - format.decimals;
  append_positional(digits.substr(0, whole), digits.substr(whole), format, out);
  return true;
}

bool append_printed_fixed(double magnitude, const NumberFormat& format, std::string& out) {
  constexpr double kLongWay = 1e17;
  if (!(magnitude < kLongWay)) return false;
  char buffer[kMaxNumberLength];
  const char* end = fmt::format_to(buffer, FMT_COMPILE("{:.{}f}"), magnitude, static_cast<int>(format.decimals));
  const std::string_view text(buffer, static_cast<std::size_t>(end - buffer));
  if (read_number(text).value != magnitude) return false;
  const std::size_t whole = std::min(text.find('.'), text.size());
  append_positional(text.substr(0, whole), whole < text.size() ? text.substr(whole + 1) : "", format, out);
  return true;
}

/// Shortest digits of a positive number, without zeros at either end, and the power of ten of the first.
struct ShortestDigits {
  char digits[32];
  int count = 0;
  int exponent = 0;
};

ShortestDigits shortest_digits(double magnitude) {
  ShortestDigits result;
  char buffer[kMaxNumberLength];
  const char* end = fmt::format_to(buffer, FMT_COMPILE("{}"), magnitude);
  int places_before_point = 0;
  bool behind_point = false;
  const char* p = buffer;
  for (; p != end && *p != 'e'; ++p) {
    if (*p == '.') {
      behind_point = true;
      continue;
    }
    if (*p == '0' && result.count == 0) {
      places_before_point -= behind_point ? 1 : 0;
      continue;
    }
    result.digits[result.count++] = *p;
    places_before_point += behind_point ? 0 : 1;
  }
  while (result.count > 1 && result.digits[result.count - 1] == '0') --result.count;
  int written_exponent = 0;
  for (const char* digit = p; digit != end; ++digit) {
    if (is_digit(*digit)) written_exponent = written_exponent * 10 + (*digit - '0');
  }
  if (p != end && p[1] == '-') written_exponent = -written_exponent;
  result.exponent = written_exponent + places_before_point - 1;
  return result;
}

void append_with_exponent(const ShortestDigits& number, const NumberFormat& format, std::string& out) {
  out += number.digits[0];
  if (number.count > 1) out.append(point_or_nothing(format)).append(number.digits + 1, idx(number.count - 1));
  out += format.exponent_letter;
  out += number.exponent < 0 ? '-' : '+';
  fmt::format_to(std::back_inserter(out), "{:0{}}", std::abs(number.exponent), static_cast<int>(format.exponent_digits));
}

void append_shortest(double magnitude, const NumberFormat& format, std::string& out) {
  ShortestDigits number;
  if (magnitude != 0.0) number = shortest_digits(magnitude);
  if (magnitude != 0.0 && (number.exponent < format.exponent_below || number.exponent >= format.exponent_from)) {
    append_with_exponent(number, format, out);
    return;
  }
  std::string whole;
  std::string decimals;
  for (int i = 0; i < number.count || i <= number.exponent; ++i) {
    const char digit = i < number.count ? number.digits[i] : '0';
    if (i == 0 && number.exponent < 0) decimals.append(idx(-number.exponent - 1), '0');
    (i <= number.exponent ? whole : decimals) += digit;
  }
  if (decimals.size() < format.decimals) decimals.append(format.decimals - decimals.size(), '0');
  append_positional(whole, decimals, format, out);
}

}  // namespace

NumberRead read_number(std::string_view text, char point) {
  const NumberParts parts = split_number(text, point);
  NumberRead read;
  read.length = parts.length;
  if (parts.length == 0) return read;
  constexpr std::uint64_t kLargestExact = std::uint64_t{1} << 53;
  constexpr int kLongestMantissa = 19;
  const bool exact = parts.significant_digits <= kLongestMantissa && parts.mantissa <= kLargestExact;
  if (exact && parts.exponent >= -22 && parts.exponent <= 22) {
    const double power = kExactPowersOfTen[static_cast<std::size_t>(std::abs(parts.exponent))];
    const auto mantissa = static_cast<double>(parts.mantissa);
    read.value = parts.exponent < 0 ? mantissa / power : mantissa * power;
    if (parts.negative) read.value = -read.value;
    return read;
  }
  read.value = read_by_library(text.substr(parts.has_plus ? 1 : 0, parts.length - (parts.has_plus ? 1 : 0)), point);
  read.out_of_range = !std::isfinite(read.value) || (read.value == 0.0 && parts.significant_digits > 0);
  return read;
}

void append_number(double value, const NumberFormat& format, std::string& out) {
  if (std::isnan(value)) {
    out += "nan";
    return;
  }
  if (std::signbit(value)) out += '-';
  const double magnitude = std::abs(value);
  if (std::isinf(magnitude)) {
    out += "inf";
    return;
  }
  if (format.form == NumberFormat::Form::Fixed) {
    if (append_exact_fixed(magnitude, format, out) || append_printed_fixed(magnitude, format, out)) return;
  }
  append_shortest(magnitude, format, out);
}

bool is_not_finite_text(std::string_view word) {
  if (!word.empty() && (word.front() == '-' || word.front() == '+')) word.remove_prefix(1);
  if (word.size() > 3 && word.substr(0, 3) == "1.#") return true;
  if (word.size() >= 4 && equal_ignoring_case(word.substr(0, 4), "nan(")) return word.back() == ')';
  return equal_ignoring_case(word, "nan") || equal_ignoring_case(word, "inf") || equal_ignoring_case(word, "infinity");
}

}  // namespace marey
