#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace marey {

/// How a number is spelled. The defaults give the canonical form: the shortest text that reads back as the same double,
/// with at least one decimal ("0.0", "93.042686", "1e-09").
struct NumberFormat {
  enum class Form : std::uint8_t {
    Fixed,     ///< exactly `decimals` digits behind the point
    Shortest,  ///< as few digits as the value needs, but at least `decimals` behind the point
  };
  Form form = Form::Shortest;
  std::uint8_t decimals = 1;         ///< 0 to kMaxDecimals; 0 writes no point
  char point = '.';                  ///< '.' or ','
  bool leading_zero = true;          ///< "0.5" or ".5"
  std::int8_t exponent_below = -4;   ///< values below 10^exponent_below are written with an exponent,
  std::int8_t exponent_from = 16;    ///< and values from 10^exponent_from on
  std::uint8_t exponent_digits = 2;  ///< at least so many: "1e-7", "1e-07", "1e-007"
  char exponent_letter = 'e';        ///< 'e' or 'E'
  friend bool operator==(const NumberFormat&, const NumberFormat&) = default;
};

inline constexpr int kMaxDecimals = 40;
/// Longest text that append_number() adds, whatever the format: 17 digits with a sign, a point and an exponent of 255 digits.
/// Without an exponent there are less: 127 digits and 40 decimals, or 128 zeros and 17 digits.
inline constexpr int kMaxNumberLength = 288;

/// Appends `value` in the given format. Where that form would not read back as the same bits, the shortest form that
/// does is written instead. Not a number and infinities become "nan", "inf" and "-inf".
void append_number(double value, const NumberFormat& format, std::string& out);

/// What the start of a text says as a number.
struct NumberRead {
  double value = 0.0;
  std::size_t length = 0;   ///< bytes of the number; 0 when there is none
  bool out_of_range = false;  ///< too large for a double (value is infinite) or too small (value is 0)
};

/// Reads a decimal number ("-12", "+.5", "3.", "1e-007") at the start of `text`, rounded correctly and whatever the
/// locale. `point` is the decimal sign.
[[nodiscard]] NumberRead read_number(std::string_view text, char point = '.');

/// True for the spellings of "not a number" and of infinity that C libraries and MSVC print: nan, -nan(ind), inf,
/// -1.#IND, 1.#QNAN ... in any case. `word` is the whole token.
[[nodiscard]] bool is_not_finite_text(std::string_view word);

}  // namespace marey
