#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/number_text.h"
#include "core/base/plain_number.h"

namespace marey {

/// A NumberFormat, prepared for the question whether a plain number of a text is what append_number() would write.
class PlainSpelling {
 public:
  PlainSpelling() = default;
  explicit PlainSpelling(const NumberFormat& format);

  /// `begin` is the first byte of the number. False also where only writing the number could tell.
  [[nodiscard]] bool matches(const char* begin, const PlainNumber& number) const {
    const int integer_digits = number.integer_digits;
    const bool usual_start = integer_digits == 1 || (integer_digits > 1 && begin[number.negative ? 1 : 0] != '0');
    const bool usual_point = number.has_point == (number.decimals > 0);
    if (!usual_start || !usual_point || number.mantissa >= unique_below_) return false;
    return shortest_ ? matches_shortest(number) : number.decimals == decimals_;
  }

 private:
  [[nodiscard]] bool matches_shortest(const PlainNumber& number) const {
    const bool no_surplus_zero = number.decimals > decimals_ && number.end[-1] != '0';
    if (number.decimals != decimals_ && !no_surplus_zero) return false;
    const double magnitude = number.magnitude();
    return magnitude == 0.0 || (magnitude >= smallest_ && magnitude < end_);
  }

  std::uint64_t unique_below_ = 0;  ///< no other digits of the same form give the same value; 0 matches nothing
  int decimals_ = 0;
  bool shortest_ = false;
  double smallest_ = 0.0;  ///< written without an exponent: [smallest_, end_)
  double end_ = 0.0;
};

/// True if append_number() with this format writes `value` as `text`.
[[nodiscard]] bool is_spelled_as(std::string_view text, double value, const NumberFormat& format);

}  // namespace marey
