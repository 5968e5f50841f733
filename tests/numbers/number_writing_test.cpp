// Writing numbers against writers that know nothing of this one: std::to_chars for the shortest digits, printf for fixed
// decimals.
#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <version>

#include "core/base/bits.h"
#include "core/base/number_text.h"
#include "tests/numbers/number_cases.h"
#include "tests/support/random_clip.h"

namespace marey {
namespace {

using test::Random;

#ifdef __EMSCRIPTEN__
constexpr std::int64_t kUsualCases = 100'000;
#else
constexpr std::int64_t kUsualCases = 5'000'000;
#endif

std::string written(double value, const NumberFormat& format = {}) {
  std::string text;
  append_number(value, format, text);
  return text;
}

/// The significant digits of a text without zeros at either end: "0.00120e5" has "12".
std::string digits_of(const std::string& text) {
  std::string digits;
  for (const char c : text) {
    if (c == 'e' || c == 'E') break;
    if (c >= '0' && c <= '9') digits += c;
  }
  const std::size_t first = digits.find_first_not_of('0');
  if (first == std::string::npos) return "0";
  return digits.substr(first, digits.find_last_not_of('0') - first + 1);
}

/// Digits of the shortest text that reads back as `value`.
std::string shortest_digits_of(double value) {
#ifdef __cpp_lib_to_chars
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific).ptr;
  return digits_of(std::string(buffer, end));
#else
  char buffer[64];
  for (int decimals = 0;; ++decimals) {
    std::snprintf(buffer, sizeof buffer, "%.*e", decimals, value);
    if (same_bits(std::strtod(buffer, nullptr), value)) return digits_of(buffer);
  }
#endif
}

double random_value(Random& random) {
  if (random.one_in(2)) return random.any_finite();
  return test::random_sample(random);
}

TEST(NumberWriting, GivesTheShortestDigitsThatReadBack) {
  Random random(103);
  const std::int64_t cases = test::number_cases(4 * kUsualCases) / 4;
  for (std::int64_t i = 0; i < cases; ++i) {
    const double value = random_value(random);
    const std::string text = written(value);
    ASSERT_TRUE(same_bits(std::strtod(text.c_str(), nullptr), value)) << text;
    ASSERT_EQ(digits_of(text), shortest_digits_of(value)) << text;
  }
  std::cout << cases << " numbers written and compared with the shortest digits of the standard library\n";
}

/// What printf writes, if that reads back as the same bits; else empty.
std::string fixed_by_printf(double value, int decimals) {
  char buffer[512];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
  return same_bits(std::strtod(buffer, nullptr), value) ? buffer : "";
}

TEST(NumberWriting, GivesFixedDecimalsExactlyWhereTheyReadBack) {
  constexpr double kLongWay = 1e17;  // from here on the shortest form is written in any case
  Random random(104);
  std::int64_t fixed = 0;
  const std::int64_t cases = test::number_cases(4 * kUsualCases) / 4;
  NumberFormat format;
  format.form = NumberFormat::Form::Fixed;
  for (std::int64_t i = 0; i < cases; ++i) {
    const int decimals = random.below(10);
    format.decimals = static_cast<std::uint8_t>(decimals);
    const double value = random.one_in(4) ? random_value(random) : std::strtod(test::file_like_text(random).c_str(), nullptr);
    const std::string text = written(value, format);
    const std::string expected = std::abs(value) < kLongWay ? fixed_by_printf(value, decimals) : "";
    ASSERT_TRUE(same_bits(std::strtod(text.c_str(), nullptr), value)) << text;
    if (expected.empty()) {
      ASSERT_EQ(digits_of(text), shortest_digits_of(value)) << text;
    } else {
      ASSERT_EQ(text, expected);
      ++fixed;
    }
  }
  EXPECT_GT(fixed, cases / 8);
  std::cout << cases << " numbers written with fixed decimals and compared with printf, " << fixed << " kept the decimals\n";
}

}  // namespace
}  // namespace marey
