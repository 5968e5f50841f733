#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/base/fixed_number.h"
#include "core/base/number_spelling.h"
#include "core/base/number_text.h"
#include "tests/support/random.h"
#include "tests/support/random_clip.h"

namespace marey {
namespace {

using Form = NumberFormat::Form;
using test::Random;

std::string written(double value, const NumberFormat& format = {}) {
  std::string text;
  append_number(value, format, text);
  return text;
}

NumberFormat fixed(int decimals) {
  NumberFormat format;
  format.form = Form::Fixed;
  format.decimals = static_cast<std::uint8_t>(decimals);
  return format;
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

NumberFormat random_format(Random& random) {
  NumberFormat format;
  format.form = random.one_in(2) ? Form::Fixed : Form::Shortest;
  format.decimals = static_cast<std::uint8_t>(random.below(kMaxDecimals + 1));
  if (random.one_in(2)) format.decimals = static_cast<std::uint8_t>(random.below(8));
  format.point = random.one_in(4) ? ',' : '.';
  format.leading_zero = !random.one_in(4);
  format.exponent_below = random.one_in(2) ? -4 : -6;
  format.exponent_from = static_cast<std::int8_t>(std::vector{6, 16, 21}[static_cast<std::size_t>(random.below(3))]);
  format.exponent_digits = static_cast<std::uint8_t>(1 + random.below(3));
  format.exponent_letter = random.one_in(3) ? 'E' : 'e';
  return format;
}

TEST(AppendNumber, ReadsBackAsTheSameBitsInEveryFormat) {
  Random random(11);
  for (int i = 0; i < 300'000; ++i) {
    const NumberFormat format = random_format(random);
    const double value = test::random_sample(random);
    const std::string text = written(value, format);
    const NumberRead read = read_number(text, format.point);
    ASSERT_EQ(read.length, text.size()) << text;
    ASSERT_TRUE(same_bits(read.value, value)) << text << " for " << value;
    ASSERT_LE(text.size(), static_cast<std::size_t>(kMaxNumberLength)) << text;
  }
}

TEST(AppendNumber, IsNeverLongerThanItSays) {
  Random random(12);
  std::size_t longest = 0;
  for (int i = 0; i < 200'000; ++i) {
    NumberFormat format = random_format(random);
    format.exponent_below = static_cast<std::int8_t>(random.one_in(2) ? -128 : random.below(256) - 128);
    format.exponent_from = static_cast<std::int8_t>(random.one_in(2) ? 127 : random.below(256) - 128);
    format.exponent_digits = static_cast<std::uint8_t>(random.below(256));
    const double power = std::pow(10.0, random.below(616) - 307);
    for (const double value : {test::random_sample(random), power, -1.2345678901234567 * power, -0.1 / power}) {
      longest = std::max(longest, written(value, format).size());
    }
  }
  EXPECT_GT(longest, 270u);
  EXPECT_LE(longest, static_cast<std::size_t>(kMaxNumberLength));
}

TEST(AppendNumber, GivesBackTheDecimalsOfAFile) {
  Random random(12);
  for (int i = 0; i < 200'000; ++i) {
    const int decimals = random.below(10);
    std::string text = random.one_in(2) ? "-" : "";
    text += std::to_string(random.below(random.one_in(3) ? 100'000 : 400));
    if (decimals > 0) text += '.';
    for (int d = 0; d < decimals; ++d) text += static_cast<char>('0' + random.below(10));
    ASSERT_EQ(written(read_number(text).value, fixed(decimals)), text);
  }
}

TEST(AppendNumber, WritesFixedDecimals) {
  EXPECT_EQ(written(0.0, fixed(6)), "0.000000");
  EXPECT_EQ(written(-0.0, fixed(4)), "-0.0000");
  EXPECT_EQ(written(93.042686, fixed(6)), "93.042686");
  EXPECT_EQ(written(-5e-06, fixed(6)), "-0.000005");
  EXPECT_EQ(written(12.0, fixed(0)), "12");
  EXPECT_EQ(written(-170.91949462890625, fixed(14)), "-170.91949462890625");
}

TEST(AppendNumber, LeavesTheFixedFormRatherThanLoseBits) {
  EXPECT_EQ(written(1.23456789, fixed(4)), "1.23456789");
  EXPECT_EQ(written(0.1 + 0.2, fixed(4)), "0.30000000000000004");
  EXPECT_EQ(written(1e-9, fixed(4)), "1e-09");
  EXPECT_EQ(written(1.5, fixed(0)), "1.5");
  EXPECT_EQ(written(1e300, fixed(2)), "1e+300");
}

TEST(AppendNumber, WritesTheShortestDigits) {
  EXPECT_EQ(written(0.0), "0.0");
  EXPECT_EQ(written(-0.0), "-0.0");
  EXPECT_EQ(written(1.0), "1.0");
  EXPECT_EQ(written(0.1), "0.1");
  EXPECT_EQ(written(93.042686), "93.042686");
  EXPECT_EQ(written(0.0001), "0.0001");
  EXPECT_EQ(written(0.00001), "1e-05");
  EXPECT_EQ(written(1234567890123456.0), "1234567890123456.0");
  EXPECT_EQ(written(1e16), "1e+16");
  EXPECT_EQ(written(5e-324), "5e-324");
}

TEST(AppendNumber, FollowsTheHabitsOfOtherLanguages) {
  NumberFormat c;  // printf("%g") of MSVC
  c.decimals = 0;
  c.exponent_digits = 3;
  c.exponent_from = 6;
  EXPECT_EQ(written(8.88178e-16, c), "8.88178e-016");
  EXPECT_EQ(written(-2.0, c), "-2");
  EXPECT_EQ(written(1234570.0, c), "1.23457e+006");
  NumberFormat javascript;
  javascript.decimals = 0;
  javascript.exponent_below = -6;
  javascript.exponent_from = 21;
  javascript.exponent_digits = 1;
  EXPECT_EQ(written(1.8463134843216267e-7, javascript), "1.8463134843216267e-7");
  EXPECT_EQ(written(0.000001, javascript), "0.000001");
  EXPECT_EQ(written(1e20, javascript), "100000000000000000000");
  NumberFormat bare = fixed(4);
  bare.leading_zero = false;
  EXPECT_EQ(written(-0.25, bare), "-.2500");
  bare.point = ',';
  EXPECT_EQ(written(0.25, bare), ",2500");
}

TEST(AppendNumber, NamesWhatIsNoNumber) {
  EXPECT_EQ(written(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(written(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(written(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(Spelling, IsRecognisedExactlyWhenItWouldBeWritten) {
  Random random(13);
  int recognised = 0;
  for (int i = 0; i < 200'000; ++i) {
    const NumberFormat format = random_format(random);
    const std::string text = written(random.one_in(2) ? random.between(-99, 99) : test::random_sample(random),
                                     random.one_in(2) ? format : random_format(random));
    const double value = read_number(text, format.point).value;
    const bool same = written(value, format) == text;
    ASSERT_EQ(is_spelled_as(text, value, format), same) << text;
    const std::string padded = text + std::string(kPlainNumberReach, ' ');
    const PlainNumber plain = scan_plain_number(padded.data(), format.point);
    if (plain.end == nullptr || !PlainSpelling(format).matches(padded.data(), plain)) continue;
    ASSERT_TRUE(same) << text;
    ++recognised;
  }
  EXPECT_GT(recognised, 5'000);
}

TEST(FixedNumberWriter, WritesAsAppendNumberDoes) {
  Random random(5);
  int written_count = 0;
  for (int i = 0; i < 300'000; ++i) {
    const int decimals = 1 + random.below(FixedNumberWriter::kMostDecimals);
    // Mostly what a file with so many decimals can hold, else any double.
    const double any = random.one_in(10) ? random.any_finite() : std::ldexp(random.unit() - 0.5, random.below(32));
    const std::string rounded = fmt::format("{:.{}f}", any, random.one_in(4) ? 17 : decimals);
    const double value = std::strtod(rounded.c_str(), nullptr);
    char text[FixedNumberWriter::kReach];
    char* end = FixedNumberWriter(decimals).write(value, text);
    if (end == nullptr) continue;
    ++written_count;
    ASSERT_EQ(std::string(&text[0], end), written(value, fixed(decimals)));
  }
  EXPECT_GT(written_count, 100'000);
}

TEST(FixedNumberWriter, WritesTheEndsOfItsRange) {
  const auto text_of = [](double value, int decimals) {
    char text[FixedNumberWriter::kReach];
    char* end = FixedNumberWriter(decimals).write(value, text);
    return end == nullptr ? std::string() : std::string(&text[0], end);
  };
  EXPECT_EQ(text_of(0.0, 6), "0.000000");
  EXPECT_EQ(text_of(-0.0, 2), "-0.00");
  EXPECT_EQ(text_of(0.00000001, 8), "0.00000001");
  EXPECT_EQ(text_of(99999999.5, 1), "99999999.5");
  EXPECT_EQ(text_of(-9999999.9999999, 7), "-9999999.9999999");
  EXPECT_EQ(text_of(180.0, 6), "180.000000");
  for (const double value : {1e8, -1e300, std::numeric_limits<double>::infinity(), std::nan(""), 0.123}) {
    EXPECT_EQ(text_of(value, 2), "") << value;
  }
  char text[FixedNumberWriter::kReach];
  EXPECT_EQ(FixedNumberWriter().write(1.5, text), nullptr);
}

}  // namespace
}  // namespace marey
