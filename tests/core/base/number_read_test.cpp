#include <fast_float/fast_float.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/base/bits.h"
#include "core/base/fixed_number.h"
#include "core/base/index.h"
#include "core/base/number_text.h"
#include "core/base/plain_number.h"
#include "tests/support/random.h"

namespace marey {
namespace {

using test::Random;

std::uint64_t bits_of(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

double read_by_fast_float(const std::string& text) {
  double value = 0.0;
  fast_float::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Compares all readers on one text; false on a difference.
bool all_readers_agree(const std::string& text) {
  const NumberRead read = read_number(text);
  const double expected = read_by_fast_float(text);
  bool agree = read.length == text.size() && bits_of(read.value) == bits_of(expected) &&
               bits_of(expected) == bits_of(std::strtod(text.c_str(), nullptr));
  const std::string padded = text + std::string(kPlainNumberReach, ' ');
  const PlainNumber plain = scan_plain_number(padded.data());
  if (plain.end != nullptr) {
    agree = agree && plain.end == padded.data() + text.size() && bits_of(plain.value()) == bits_of(expected);
  }
  EXPECT_TRUE(agree) << text;
  return agree;
}

/// Text with random digits, point and exponent.
std::string random_number_text(Random& random) {
  std::string text = random.one_in(2) ? "-" : "";
  const int integer_digits = random.below(random.one_in(20) ? 24 : 5);
  const int decimals = random.below(random.one_in(20) ? 24 : 9);
  for (int i = 0; i < integer_digits; ++i) text += static_cast<char>('0' + random.below(10));
  if (decimals > 0 || integer_digits == 0) text += '.';
  for (int i = 0; i < decimals + (integer_digits == 0 ? 1 : 0); ++i) text += static_cast<char>('0' + random.below(10));
  if (random.one_in(8)) text += fmt::format("{}{}{}", random.one_in(2) ? "e" : "E", random.one_in(2) ? "-" : "+", random.below(330));
  return text;
}

TEST(ReadNumber, AgreesWithFastFloatAndStrtodOnRandomTexts) {
  Random random(1);
  for (int i = 0; i < 600'000; ++i) {
    if (!all_readers_agree(random_number_text(random))) return;
  }
}

TEST(ReadNumber, AgreesWithFastFloatAndStrtodOnAllBitPatterns) {
  Random random(2);
  for (int i = 0; i < 200'000; ++i) {
    const double value = random.any_finite();
    const std::string text = fmt::format("{}", value);
    ASSERT_EQ(bits_of(read_number(text).value), bits_of(value)) << text;
    if (!all_readers_agree(fmt::format("{:.{}e}", value, random.below(20)))) return;
  }
}

TEST(ReadNumber, RoundsHalfwayCasesToEven) {
  Random random(3);
  for (int i = 0; i < 100'000; ++i) {
    // The point halfway between two neighbouring doubles, with all its digits, and a digit above and below it.
    const double low = std::abs(random.between(1e-3, 1e6));
    const double high = std::nextafter(low, 1e300);
    const long double middle = (static_cast<long double>(low) + static_cast<long double>(high)) / 2;
    const std::string text = fmt::format("{:.60f}", middle);
    if (!all_readers_agree(text) || !all_readers_agree(text + "1")) return;
  }
}

TEST(ReadNumber, AgreesOnKnownHardCases) {
  for (const std::string text :
       {"9007199254740993", "9007199254740992.5", "90071992547409.93", "1e23", "8.5e22", "9.5367431640625e-7",
        "2.2250738585072011e-308", "2.2250738585072014e-308", "4.9406564584124654e-324", "2.4703282292062327e-324",
        "1.7976931348623157e308", "0.1", "0.30000000000000004", "123456789012345678", "1234567890123456789012",
        "0.000000000000000000000000001", "100000000000000000000000", "7.2057594037927933e16", "6.02214076e23",
        "0000000000000000000000000.5", "12345678.12345678", "123456789.123456789", "12345678.1234567812345678"}) {
    all_readers_agree(text);
  }
}

TEST(ReadNumber, TakesEverySpellingOfFiniteNumbers) {
  const std::vector<std::pair<std::string, double>> cases = {
      {"0", 0.0},          {"-0", -0.0},          {"-0.0", -0.0},       {"+5", 5.0},          {".5", 0.5},
      {"-.25", -0.25},     {"3.", 3.0},           {"1e3", 1000.0},      {"1E3", 1000.0},      {"1e+3", 1000.0},
      {"1e-007", 1e-7},    {"8.88178e-016", 8.88178e-16}, {"007", 7.0}, {".0083333", 0.0083333},
      {"-1.31542e-47", -1.31542e-47}};
  for (const auto& [text, value] : cases) {
    const NumberRead read = read_number(text);
    EXPECT_EQ(read.length, text.size()) << text;
    EXPECT_EQ(bits_of(read.value), bits_of(value)) << text;
    EXPECT_FALSE(read.out_of_range) << text;
  }
}

TEST(ReadNumber, StopsWhereTheNumberEnds) {
  const std::vector<std::pair<std::string, std::size_t>> cases = {
      {"", 0},   {"-", 0},      {".", 0},      {"-.", 0},      {"e5", 0},   {"abc", 0},   {"1.5abc", 3}, {"0.0-7.509", 3},
      {"1e", 1}, {"1e+", 1},    {"1.2.3", 3},  {"1,5", 1},     {"--1", 0},  {"1 2", 1},   {"+-1", 0},    {"1}", 1}};
  for (const auto& [text, length] : cases) EXPECT_EQ(read_number(text).length, length) << text;
}

TEST(ReadNumber, TakesADecimalCommaWhenAskedTo) {
  EXPECT_EQ(read_number("-12,75", ',').value, -12.75);
  EXPECT_EQ(read_number("-12,75", ',').length, 6U);
  EXPECT_EQ(read_number("0,1234567890123456789", ',').value, 0.1234567890123456789);
  EXPECT_EQ(read_number("12.75", ',').length, 2U);
}

TEST(ReadNumber, SaysWhenANumberLeavesTheRangeOfDoubles) {
  EXPECT_TRUE(read_number("1e999").out_of_range);
  EXPECT_TRUE(std::isinf(read_number("-1e999").value));
  EXPECT_TRUE(read_number("1e-999").out_of_range);
  EXPECT_EQ(read_number("1e-999").value, 0.0);
  EXPECT_FALSE(read_number("0e-999").out_of_range);
  EXPECT_FALSE(read_number("0e999").out_of_range);
  EXPECT_FALSE(read_number("5e-324").out_of_range);
  EXPECT_TRUE(read_number("1e99999999999999999999").out_of_range);
}

TEST(ReadNumber, IgnoresTheLocale) {
  // No locale is set: that the library functions used do not look at it is what number_read_test pins by agreeing with
  // fast_float, which never does.
  EXPECT_EQ(read_number("1.5").value, 1.5);
  EXPECT_EQ(read_number("1,5").value, 1.0);
}

TEST(ScanPlainNumber, RefusesWhatIsNotPlain) {
  for (const std::string text : {"+1", "e5", "", "-", ".", "abc", "123456789", "1.12345678901234567", "nan",
                                 "99999999.99999999999"}) {
    EXPECT_EQ(scan_plain_number((text + std::string(kPlainNumberReach, ' ')).data()).end, nullptr) << text;
  }
}

TEST(FixedNumberReader, ReadsExactlyWhatIsWrittenWithItsDecimals) {
  Random random(4);
  int read_count = 0;
  for (int i = 0; i < 200'000; ++i) {
    const std::string text = random_number_text(random);
    const int gap = random.below(FixedNumberReader::kLongestGap + 1);
    const std::string line = std::string(idx(gap), ' ') + text + "\n" + std::string(kPlainNumberReach, '1');
    const int decimals = 1 + random.below(FixedNumberReader::kMostDecimals);
    double value = 0.0;
    const char* end = FixedNumberReader(decimals).read(line.data(), detail::load_eight(line.data()), gap, value);
    if (end == nullptr) continue;
    ++read_count;
    ASSERT_EQ(end, line.data() + idx(gap) + text.size()) << text;
    ASSERT_TRUE(same_bits(value, std::strtod(text.c_str(), nullptr))) << text;
    std::string written;
    append_number(value, {.form = NumberFormat::Form::Fixed, .decimals = static_cast<std::uint8_t>(decimals)}, written);
    ASSERT_EQ(written, text);
  }
  EXPECT_GT(read_count, 2'000);
}

TEST(FixedNumberReader, RefusesEverythingElse) {
  const auto read = [](const std::string& text, double& value) {
    const std::string line = " " + text + "\n" + std::string(kPlainNumberReach, '1');
    return FixedNumberReader(2).read(line.data(), detail::load_eight(line.data()), 1, value) != nullptr;
  };
  double value = 0.0;
  for (const std::string text : {"1.5", "1.555", ".55", "01.55", "1,55", "1.5x", "x.55", "-.55", "--1.55", "1.55e1", "12345678.55",
                                 "1.-5", "1 .55", "+1.55", "nan", "1.5:", "1.:5", "/.55", ":.55", "1.55-2"}) {
    EXPECT_FALSE(read(text, value)) << text;
  }
  EXPECT_TRUE(read("-1.55", value));
  EXPECT_EQ(value, -1.55);
  EXPECT_TRUE(read("-0.00", value));
  EXPECT_TRUE(same_bits(value, -0.0));
  const std::string sound = "1.55 " + std::string(kPlainNumberReach, '1');
  EXPECT_EQ(FixedNumberReader().read(sound.data(), detail::load_eight(sound.data()), 0, value), nullptr);
}

TEST(NotFiniteText, KnowsTheSpellingsOfCLibraries) {
  for (const std::string text : {"nan", "NaN", "-nan", "+nan", "nan(ind)", "-nan(ind)", "inf", "-inf", "Infinity",
                                 "1.#IND", "-1.#IND", "1.#QNAN", "1.#INF", "-1.#INF000"}) {
    EXPECT_TRUE(is_not_finite_text(text)) << text;
  }
  for (const std::string text : {"", "-", "1.", "name", "nano", "1.5", "infinite", "n"}) {
    EXPECT_FALSE(is_not_finite_text(text)) << text;
  }
}

}  // namespace
}  // namespace marey
