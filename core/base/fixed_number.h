#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/base/number_text.h"
#include "core/base/plain_number.h"

namespace marey {

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

/// Whether FixedNumberWriter and FixedNumbers know a format's ordinary numbers.
[[nodiscard]] inline bool is_usual_fixed(const NumberFormat& format) {
  return format.form == NumberFormat::Form::Fixed && format.leading_zero && format.point == '.' && format.decimals >= 1 &&
         format.decimals <= FixedNumberWriter::kMostDecimals;
}

}  // namespace marey
