#include "tests/numbers/number_cases.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace marey::test {
namespace {

static_assert(std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits,
              "a point halfway between two doubles needs one bit more than a double has");

void append_digits(Random& random, int count, std::string& text) {
  while (count > 0) {
    std::uint64_t bits = random.bits();
    for (int i = 0; i < 16 && count > 0; ++i, --count, bits /= 10) text += static_cast<char>('0' + bits % 10);
  }
}

double with_bits(std::uint64_t bits) {
  double value = 0.0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// A positive double: any exponent, a usual one, or the smallest ones.
double random_positive(Random& random) {
  if (random.one_in(3)) return std::abs(random.any_finite());
  if (random.one_in(3)) return with_bits(random.bits() % (std::uint64_t{1} << (1 + random.below(52))));
  return std::ldexp(1.0 + random.unit(), random.below(120) - 60);
}

}  // namespace

std::int64_t number_cases(std::int64_t usual) {
  const char* wanted = std::getenv("MAREY_NUMBER_CASES");
  return wanted != nullptr ? std::atoll(wanted) : usual;
}

std::string file_like_text(Random& random) {
  std::string text = random.one_in(2) ? "-" : "";
  text += std::to_string(random.below(random.one_in(4) ? 2000 : 180));
  text += '.';
  append_digits(random, random.one_in(4) ? 1 + random.below(9) : 6, text);
  return text;
}

std::string shortest_text(Random& random) { return fmt::format("{}", random.any_finite()); }

std::string long_text(Random& random) {
  std::string text = random.one_in(2) ? "-" : "";
  const std::size_t begin = text.size();
  const int digits = 15 + random.below(11);
  append_digits(random, digits, text);
  if (random.one_in(3)) text.append(static_cast<std::size_t>(random.below(30)), '0');
  if (!random.one_in(4)) text.insert(begin + static_cast<std::size_t>(random.below(digits + 1)), ".");
  if (random.one_in(4)) text += fmt::format("e{}", random.below(80) - 40);
  return text;
}

std::string text_with_exponent(Random& random) {
  std::string text = random.one_in(2) ? "-" : "";
  append_digits(random, 1, text);
  text += '.';
  append_digits(random, random.below(20), text);
  return text + fmt::format("{}{:+04}", random.one_in(2) ? 'e' : 'E', random.below(720) - 360);
}

std::string text_at_the_ends(Random& random) {
  const std::uint64_t few = random.bits() >> (12 + random.below(50));
  const std::uint64_t largest = 0x7fefffffffffffffU;
  const double value = with_bits(random.one_in(2) ? few : largest - few);
  return fmt::format("{:.{}e}", value, random.below(25));
}

HalfwayTexts halfway_texts(Random& random) {
  constexpr int kDigits = 780;
  const double low = random_positive(random);
  const double high = std::nextafter(low, std::numeric_limits<double>::infinity());
  // The last double has no neighbour above; the one below it serves as well.
  const double other = std::isinf(high) ? std::nextafter(low, 0.0) : high;
  const long double middle = (static_cast<long double>(low) + static_cast<long double>(other)) / 2;
  char buffer[kDigits + 32];
  const int size = std::snprintf(buffer, sizeof buffer, "%.*Le", kDigits, middle);
  std::string digits(buffer, static_cast<std::size_t>(size));
  const std::size_t exponent_at = digits.find('e');
  const std::string exponent = digits.substr(exponent_at);
  digits.resize(digits.find_last_not_of('0', exponent_at - 1) + 1);
  if (digits.back() == '.') digits += '0';
  std::string below = digits;
  if (below.back() != '0') --below.back();
  return {below + "9" + exponent, digits + exponent, digits + "1" + exponent};
}

}  // namespace marey::test
