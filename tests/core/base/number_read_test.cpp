#include <fast_float/fast_float.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/bits.h"
#include "core/base/fixed_numbers.h"
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
    char buffer[80];
    const std::string text(buffer, static_cast<std::size_t>(std::snprintf(buffer, sizeof buffer, "%.60Lf", middle)));
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

/// A row for FixedNumbers, between what it may look at.
class FixedRow {
 public:
  explicit FixedRow(std::string text)
      : text_(std::string(FixedNumbers::kReachBefore, '1') + std::move(text)), size_(text_.size()) {
    text_.append(FixedNumbers::kReachPerNumber * kMostNumbers + FixedNumbers::kReachBehind, '1');
  }
  static constexpr int kMostNumbers = 12;
  [[nodiscard]] bool read(const FixedNumbers& numbers, int count, double* values) const {
    const char* end = numbers.read(text_.data() + FixedNumbers::kReachBefore, count, values);
    EXPECT_TRUE(end == nullptr || end == text_.data() + size_ - 1) << text_;
    return end != nullptr;
  }

 private:
  std::string text_;
  std::size_t size_;
};

bool is_usual(const std::string& text, int decimals) {
  const std::size_t begin = text[0] == '-' ? 1 : 0;
  const std::size_t point = text.find('.');
  if (point == std::string::npos || text.size() != point + 1 + idx(decimals)) return false;
  const auto is_digits = [&](std::size_t from, std::size_t to) { return from < to && text.find_first_not_of("0123456789", from) >= to; };
  return is_digits(begin, point) && is_digits(point + 1, text.size()) && (text[begin] != '0' || point == begin + 1);
}

TEST(FixedNumbers, ReadRowsOfWhatIsWrittenWithTheirDecimals) {
  Random random(4);
  std::array<double, FixedRow::kMostNumbers> values{};
  int rows_read = 0;
  for (int i = 0; i < 100'000; ++i) {
    const std::string gap = std::string(1, " \t\n"[random.below(3)]) + std::string(idx(random.below(3)), ' ');
    const int decimals = 1 + random.below(FixedNumbers::kMostDecimals);
    const int count = 1 + random.below(FixedRow::kMostNumbers);
    std::vector<std::string> texts;
    std::string row;
    bool all_usual = true;
    for (int k = 0; k < count; ++k) {
      std::string text;
      if (random.below(20) == 0) {
        text = random_number_text(random);
      } else {
        text = fmt::format("{:.{}f}", random.between(-1.0, 1.0) * std::pow(10.0, random.below(7)), decimals);
      }
      all_usual = all_usual && is_usual(text, decimals) && gap.size() + text.find('.') <= 7;
      texts.push_back(text);
      row += gap + text;
    }
    ASSERT_EQ(FixedRow(row + " ").read(FixedNumbers(gap, decimals), count, values.data()), all_usual) << row;
    if (!all_usual) continue;
    ++rows_read;
    for (std::size_t k = 0; k < texts.size(); ++k) ASSERT_TRUE(same_bits(values[k], std::strtod(texts[k].c_str(), nullptr))) << texts[k];
  }
  EXPECT_GT(rows_read, 20'000);
}

TEST(FixedNumbers, RefuseEverythingElse) {
  const auto read = [](const std::string& text, std::span<double, 3> values) {
    return FixedRow(" 2.75 " + text + " 3.25\n").read(FixedNumbers(" ", 2), 3, values.data());
  };
  std::array<double, 3> values{};
  for (const std::string text : {"1.5", "1.555", ".55", "01.55", "1,55", "1.5x", "x.55", "-.55", "--1.55", "1.55e1", "12345678.55",
                                 "1.-5", "1 .55", "+1.55", "nan", "1.5:", "1.:5", "/.55", ":.55", "1.55-2", "", "1.55 ", " 1.55", "5", "1.\xb5" "5"}) {
    EXPECT_FALSE(read(text, values)) << text;
  }
  EXPECT_TRUE(read("-1.55", values));
  EXPECT_EQ(values[1], -1.55);
  EXPECT_TRUE(read("-0.00", values));
  EXPECT_TRUE(same_bits(values[1], -0.0));
  EXPECT_TRUE(read("123456.78", values));
  EXPECT_EQ(values, (std::array<double, 3>{2.75, 123456.78, 3.25}));
  EXPECT_FALSE(FixedRow(" 1.555").read(FixedNumbers(" ", 2), 1, values.data())) << "the last one goes on";
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
