#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "core/base/text_cursor.h"

namespace marey {

static_assert(std::endian::native == std::endian::little, "the digit tricks below read numbers from memory");

/// The powers of ten that a double holds exactly.
inline constexpr std::array<double, 23> kExactPowersOfTen = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                             1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                             1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// "[-]digits[.digits]" as found in nearly every row of a BVH file.
struct PlainNumber {
  const char* end = nullptr;   ///< behind the number; null when the text is anything but a plain number
  std::uint64_t mantissa = 0;  ///< all digits
  int integer_digits = 0;      ///< digits before the point
  int decimals = 0;            ///< digits behind the point
  bool has_point = false;
  bool negative = false;

  /// Correctly rounded when mantissa <= 2^53: both operands are exact, and IEEE division rounds once.
  [[nodiscard]] double magnitude() const {
    return static_cast<double>(mantissa) / kExactPowersOfTen[static_cast<std::size_t>(decimals)];
  }
  [[nodiscard]] double value() const { return negative ? -magnitude() : magnitude(); }
};

/// Bytes that scan_plain_number() may look at.
inline constexpr int kPlainNumberReach = 40;

namespace detail {

inline std::uint64_t load_eight(const char* p) {
  std::uint64_t bytes;
  std::memcpy(&bytes, p, sizeof bytes);
  return bytes;
}

/// Number of leading bytes (lowest address first) that are digits.
inline int count_digits(std::uint64_t bytes) {
  const std::uint64_t high_nibble_off = (bytes & 0xf0f0f0f0f0f0f0f0U) ^ 0x3030303030303030U;
  const std::uint64_t low_nibble_over = ((bytes & 0x0f0f0f0f0f0f0f0fU) + 0x0606060606060606U) & 0xf0f0f0f0f0f0f0f0U;
  const std::uint64_t not_digit = high_nibble_off | low_nibble_over;
  return not_digit == 0 ? 8 : std::countr_zero(not_digit) / 8;
}

/// The value of eight digits, the first at the lowest address.
inline std::uint64_t eight_digits(std::uint64_t bytes) {
  bytes -= 0x3030303030303030U;
  bytes = bytes * 10 + (bytes >> 8);
  const std::uint64_t even = (bytes & 0x000000ff000000ffU) * 0x000f424000000064U;
  const std::uint64_t odd = ((bytes >> 16) & 0x000000ff000000ffU) * 0x0000271000000001U;
  return (even + odd) >> 32;
}

inline constexpr std::array<std::uint64_t, 9> kPowersOfTen = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};

/// Adds up to eight digits at `p` to `mantissa`; gives how many there were.
inline int take_digits(const char* p, std::uint64_t& mantissa) {
  const std::uint64_t bytes = load_eight(p);
  const int count = count_digits(bytes);
  if (count == 0) return 0;
  // The digits move to the top, zeros fill the bytes below: "42." becomes "00000042".
  const int shift = 64 - 8 * count;
  const std::uint64_t zeros = shift == 0 ? 0 : 0x3030303030303030U >> (64 - shift);
  mantissa = mantissa * kPowersOfTen[static_cast<std::size_t>(count)] + eight_digits((bytes << shift) | zeros);
  return count;
}

}  // namespace detail

/// Reads a plain number at `p` that ends before a blank; kPlainNumberReach bytes must be readable. `end` is null for
/// exponents, a sign '+', more than 8 digits before or 16 behind the point, a mantissa over 2^53, and for what is no
/// number.
inline PlainNumber scan_plain_number(const char* p, char point = '.') {
  PlainNumber number;
  number.negative = *p == '-';
  p += number.negative ? 1 : 0;
  number.integer_digits = detail::take_digits(p, number.mantissa);
  p += number.integer_digits;
  if (*p == point) {
    number.has_point = true;
    ++p;
    number.decimals = detail::take_digits(p, number.mantissa);
    if (number.decimals == 8) number.decimals += detail::take_digits(p + 8, number.mantissa);
    p += number.decimals;
  }
  constexpr std::uint64_t kLargestExact = std::uint64_t{1} << 53;
  const bool some_digit = number.integer_digits + number.decimals > 0;
  const bool no_overflow = number.integer_digits + number.decimals <= 19;
  if (some_digit && no_overflow && number.mantissa <= kLargestExact && is_blank(*p)) number.end = p;
  return number;
}

}  // namespace marey
