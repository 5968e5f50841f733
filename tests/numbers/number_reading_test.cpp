// Reading numbers against two readers that know nothing of this one: fast_float and the C library's strtod.
#include <fast_float/fast_float.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/bits.h"
#include "core/base/fixed_numbers.h"
#include "core/base/number_text.h"
#include "core/base/plain_number.h"
#include "tests/numbers/number_cases.h"

namespace marey {
namespace {

using test::Random;

double read_by_fast_float(const std::string& text) {
  double value = 0.0;
  fast_float::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Compares the readers of the rows and of everything else with both others, counting.
class Comparison {
 public:
  void operator()(const std::string& text) {
    ++compared_;
    const double expected = read_by_fast_float(text);
    const NumberRead read = read_number(text);
    bool agree = read.length == text.size() && same_bits(read.value, expected) &&
                 same_bits(expected, std::strtod(text.c_str(), nullptr));
    padded_.assign(text).append(kPlainNumberReach, ' ');
    const PlainNumber plain = scan_plain_number(padded_.data());
    if (plain.end != nullptr) {
      ++plain_;
      agree = agree && plain.end == padded_.data() + text.size() && same_bits(plain.value(), expected);
    }
    if (const auto value = read_with_known_decimals(text)) {
      ++known_decimals_;
      agree = agree && same_bits(*value, expected);
    }
    if (!agree) ADD_FAILURE() << text;
  }
  [[nodiscard]] std::int64_t compared() const { return compared_; }
  [[nodiscard]] std::int64_t plain() const { return plain_; }
  [[nodiscard]] std::int64_t known_decimals() const { return known_decimals_; }

 private:
  /// Nothing for what is not of that kind.
  [[nodiscard]] static std::optional<double> read_with_known_decimals(const std::string& text) {
    const std::size_t point = text.find('.');
    const std::size_t decimals = point == std::string::npos ? 0 : text.size() - point - 1;
    if (decimals < 1 || decimals > FixedNumbers::kMostDecimals) return std::nullopt;
    const std::string row = std::string(FixedNumbers::kReachBefore, ' ') + text + std::string(FixedNumbers::kReachPerNumber + FixedNumbers::kReachBehind, ' ');
    const char* const gap = row.data() + FixedNumbers::kReachBefore - 1;
    double value = 0.0;
    const char* end = FixedNumbers(" ", static_cast<int>(decimals)).read(gap, 1, &value);
    if (end == nullptr) return std::nullopt;
    return end == gap + 1 + text.size() ? value : std::nan("");
  }

  std::string padded_;
  std::int64_t compared_ = 0;
  std::int64_t plain_ = 0;
  std::int64_t known_decimals_ = 0;
};

#ifdef __EMSCRIPTEN__
constexpr std::int64_t kUsualCases = 200'000;
#else
constexpr std::int64_t kUsualCases = 20'000'000;
#endif

TEST(NumberReading, IsRoundedCorrectly) {
  Random random(101);
  Comparison compare;
  const std::int64_t cases = test::number_cases(kUsualCases);
  std::int64_t halfway = 0;
  while (compare.compared() < cases && !testing::Test::HasFailure()) {
    const int kind = random.below(100);
    if (kind < 45) {
      compare(test::file_like_text(random));
    } else if (kind < 65) {
      compare(test::shortest_text(random));
    } else if (kind < 83) {
      compare(test::long_text(random));
    } else if (kind < 93) {
      compare(test::text_with_exponent(random));
    } else if (kind < 98) {
      compare(test::text_at_the_ends(random));
    } else if (kind < 99) {
      const test::HalfwayTexts texts = test::halfway_texts(random);
      for (const std::string& text : {texts.below, texts.halfway, texts.above}) compare(text);
      halfway += 3;
    }
  }
  EXPECT_GT(compare.plain(), cases / 4);
  EXPECT_GT(compare.known_decimals(), cases / 8);
  EXPECT_GT(halfway, cases / 100);
  std::cout << compare.compared() << " numbers read and compared with fast_float and strtod, " << compare.plain()
            << " of them by the reader of rows too, " << compare.known_decimals() << " as a column of known decimals, " << halfway << " within a digit of halfway between two doubles\n";
}

TEST(NumberReading, HalfwayCasesAreHard) {
  Random random(102);
  int decided_by_the_last_digit = 0;
  for (int i = 0; i < 1000; ++i) {
    const test::HalfwayTexts texts = test::halfway_texts(random);
    const double below = read_number(texts.below).value;
    const double above = read_number(texts.above).value;
    decided_by_the_last_digit += below < above ? 1 : 0;
  }
  EXPECT_EQ(decided_by_the_last_digit, 1000);
}

}  // namespace
}  // namespace marey
