#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/base/number_text.h"
#include "core/base/plain_number.h"

namespace marey {

/// Reads "[-]digits.digits" with a number of decimals that is known beforehand, as the columns of nearly every file have
/// them. Where the next number begins is known as soon as the point is found, before any digit has been looked at, so
/// that a processor works on several numbers at once; scan_plain_number() has to count digits first.
class FixedNumberReader {
 public:
  static constexpr int kMostDecimals = 8;
  static constexpr int kLongestGap = 4;

  /// Reads nothing.
  FixedNumberReader() = default;
  /// 1 <= decimals <= kMostDecimals.
  explicit FixedNumberReader(int decimals)
      : decimals_(decimals),
        fraction_shift_(64 - 8 * decimals),
        integer_scale_(detail::kPowersOfTen[static_cast<std::size_t>(decimals)]),
        scale_(kExactPowersOfTen[static_cast<std::size_t>(decimals)]) {}

  /// Reads the number behind `gap` bytes (up to kLongestGap) at `p`, where `word` are the first eight bytes. Gives its end;
  /// null for anything but a number with just these decimals, no surplus zero in front, at most 7 bytes between `p` and
  /// the point, and a blank behind. kPlainNumberReach bytes must be readable. The value is correctly rounded: at most 15
  /// digits make an exact dividend.
  [[nodiscard]] const char* read(const char* p, std::uint64_t word, int gap, double& value) const {
    const std::uint64_t points = word ^ 0x2e2e2e2e2e2e2e2eU;
    // The lowest set bit lies in the first byte that is 0.
    const std::uint64_t point_mask = (points - 0x0101010101010101U) & ~points & 0x8080808080808080U;
    // Gaps that are too long, which a reader of nothing may be asked for, must not shift by the whole word.
    const bool negative = (word >> (8 * (gap & 7)) & 0xffU) == '-';
    const int begin = gap + (negative ? 1 : 0);
    const int point = std::countr_zero(point_mask | std::uint64_t{1} << 63) >> 3;
    const int integer_digits = point - begin;
    if (integer_digits < 1) return nullptr;
    const char* fraction_at = p + point + 1;
    const char* end = fraction_at + decimals_;
    // The digits as numbers from 0 to 9, the last one in the highest byte, zeros before the first.
    const std::uint64_t integer = (word ^ kZeros) >> (8 * begin) << (64 - 8 * integer_digits);
    const std::uint64_t fraction = (detail::load_eight(fraction_at) ^ kZeros) << fraction_shift_;
    const std::uint64_t integer_value = value_of(integer);
    // One branch for all that is seldom so; the number of digits cannot be predicted.
    const std::uint64_t surplus_zero = integer_value < kSmallest[static_cast<std::size_t>(integer_digits)] ? 1 : 0;
    const std::uint64_t no_point = point_mask == 0 ? 1 : 0;
    const std::uint64_t no_end = is_blank(*end) ? 0 : 1;
    if ((bits_of_no_digits(integer, fraction) | surplus_zero | no_point | no_end) != 0) return nullptr;
    const auto mantissa = static_cast<std::int64_t>(integer_value * integer_scale_ + value_of(fraction));
    value = with_sign(static_cast<double>(mantissa) / scale_, negative);
    return decimals_ == 0 ? nullptr : end;
  }

 private:
  static constexpr std::uint64_t kZeros = 0x3030303030303030U;
  /// The least number with so many digits, of which the first is no surplus zero.
  static constexpr std::array<std::uint64_t, 9> kSmallest = {0, 0, 10, 100, 1000, 10000, 100000, 1000000, 10000000};

  /// 0 if all bytes are 0 to 9.
  static std::uint64_t bits_of_no_digits(std::uint64_t a, std::uint64_t b) {
    constexpr std::uint64_t kToHighBit = 0x7676767676767676U;
    return ((a + kToHighBit) | a | (b + kToHighBit) | b) & 0x8080808080808080U;
  }
  /// As detail::eight_digits(), of bytes from 0 to 9.
  static std::uint64_t value_of(std::uint64_t digits) {
    const std::uint64_t pairs = digits * 10 + (digits >> 8);
    const std::uint64_t even = (pairs & 0x000000ff000000ffU) * 0x000f424000000064U;
    const std::uint64_t odd = ((pairs >> 16) & 0x000000ff000000ffU) * 0x0000271000000001U;
    return (even + odd) >> 32;
  }
  /// Without a branch: signs cannot be predicted.
  static double with_sign(double magnitude, bool negative) {
    std::uint64_t bits;
    std::memcpy(&bits, &magnitude, sizeof bits);
    bits |= static_cast<std::uint64_t>(negative) << 63;
    std::memcpy(&magnitude, &bits, sizeof bits);
    return magnitude;
  }

  int decimals_ = 0;
  int fraction_shift_ = 0;
  std::uint64_t integer_scale_ = 1;
  double scale_ = 1.0;
};

/// Writes a value as its integer over a power of ten says, which is how most files hold it; append_number() does the rest.
class FixedNumberWriter {
 public:
  static constexpr int kMostDecimals = 8;
  /// Bytes that write() may touch.
  static constexpr int kReach = 24;

  /// Writes nothing.
  FixedNumberWriter() = default;
  /// 1 <= decimals <= kMostDecimals.
  explicit FixedNumberWriter(int decimals)
      : decimals_(decimals),
        scale_(kExactPowersOfTen[static_cast<std::size_t>(decimals)]),
        integer_scale_(detail::kPowersOfTen[static_cast<std::size_t>(decimals)]),
        padding_(detail::kPowersOfTen[static_cast<std::size_t>(kMostDecimals - decimals)]) {}

  /// Writes what append_number() would with these decimals, and gives its end. Null, with `out` undefined, where the value
  /// is no such decimal number, or 10^8 and above.
  [[nodiscard]] char* write(double value, char* out) const {
    constexpr double kUniqueBelow = 2251799813685248.0;  // 2^51: no other integer over the scale gives the same value
    constexpr double kEnd = 1e8;
    const double magnitude = std::abs(value);
    const double scaled = magnitude * scale_;
    if (decimals_ == 0 || !(scaled < kUniqueBelow) || !(magnitude < kEnd)) return nullptr;
    // By way of signed integers, which processors convert at once.
    const auto integer = static_cast<std::int64_t>(scaled + 0.5);
    if (static_cast<double>(integer) / scale_ != magnitude) return nullptr;
    // Below 2^51 the quotient is never rounded up to the next whole number.
    const auto whole = static_cast<std::uint64_t>(static_cast<std::int64_t>(magnitude));
    *out = '-';
    out += std::signbit(value) ? 1 : 0;
    const std::uint64_t whole_digits = digits_of(whole);
    const int leading_zeros = std::countr_zero(whole_digits | std::uint64_t{1} << 56) / 8;
    store(out, (whole_digits | kZeros) >> (8 * leading_zeros));
    out += 8 - leading_zeros;
    *out++ = '.';
    store(out, digits_of((static_cast<std::uint64_t>(integer) - whole * integer_scale_) * padding_) | kZeros);
    return out + decimals_;
  }

 private:
  static constexpr std::uint64_t kZeros = 0x3030303030303030U;

  static void store(char* out, std::uint64_t bytes) { std::memcpy(out, &bytes, sizeof bytes); }

  /// The eight digits of a number below 10^8, a byte each, the first at the lowest address. Halves are split three times,
  /// all parts at once; the factors are reciprocals of 100 and 10, exact for the numbers that occur.
  static std::uint64_t digits_of(std::uint64_t number) {
    const std::uint64_t fours = number / 10000 | (number % 10000) << 32;
    const std::uint64_t hundreds = (fours * 10486 >> 20) & 0x0000007f0000007fU;
    const std::uint64_t twos = hundreds | (fours - 100 * hundreds) << 16;
    const std::uint64_t tens = (twos * 103 >> 10) & 0x000f000f000f000fU;
    return tens | (twos - 10 * tens) << 8;
  }

  int decimals_ = 0;
  double scale_ = 1.0;
  std::uint64_t integer_scale_ = 1;
  std::uint64_t padding_ = 1;
};

/// Whether the two above know a format's ordinary numbers.
[[nodiscard]] inline bool is_usual_fixed(const NumberFormat& format) {
  return format.form == NumberFormat::Form::Fixed && format.leading_zero && format.point == '.' && format.decimals >= 1 &&
         format.decimals <= FixedNumberReader::kMostDecimals;
}

}  // namespace marey
