#include "core/bvh/format_guess.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/base/index.h"
#include "core/base/text_cursor.h"

namespace marey {
namespace {

using Numbers = std::vector<std::string_view>;

bool has_exponent(std::string_view number) { return number.find_first_of("eE") != std::string_view::npos; }

/// The decimals that most numbers have, as a format.
NumberFormat usual_fixed_format(const Numbers& numbers, char point) {
  std::array<int, kMaxDecimals + 1> count{};
  for (const std::string_view number : numbers) {
    const int decimals = count_decimals(number, point);
    if (decimals >= 0 && decimals <= kMaxDecimals) ++count[idx(decimals)];
  }
  NumberFormat format;
  format.form = NumberFormat::Form::Fixed;
  format.point = point;
  format.decimals = static_cast<std::uint8_t>(std::max_element(count.begin(), count.end()) - count.begin());
  return format;
}

/// How many of the numbers the format spells as they stand.
int count_matches(const Numbers& numbers, const NumberFormat& format) {
  int matches = 0;
  std::string text;
  for (const std::string_view number : numbers) {
    text.clear();
    append_number(read_number(number, format.point).value, format, text);
    matches += text == number ? 1 : 0;
  }
  return matches;
}

/// Letter and digits of the exponents as the first number with an exponent has them.
void learn_exponent(const Numbers& numbers, NumberFormat& format) {
  const auto found = std::find_if(numbers.begin(), numbers.end(), has_exponent);
  if (found == numbers.end()) return;
  const std::size_t letter = found->find_first_of("eE");
  std::string_view digits = found->substr(letter + 1);
  if (!digits.empty() && !is_digit(digits.front())) digits.remove_prefix(1);
  format.exponent_letter = (*found)[letter];
  format.exponent_digits = static_cast<std::uint8_t>(std::clamp(size_of(digits), 1, 3));
}

struct FormatScore {
  NumberFormat format;
  int matches = -1;
};

/// Tries the habits of the usual languages: C ("%g" and "%.9g"), Python, JavaScript, .NET.
FormatScore best_shortest_format(const Numbers& numbers, char point) {
  NumberFormat base;
  base.form = NumberFormat::Form::Shortest;
  base.point = point;
  learn_exponent(numbers, base);
  base.leading_zero = std::none_of(numbers.begin(), numbers.end(), [point](std::string_view number) {
    const std::size_t sign = !number.empty() && number.front() == '-' ? 1 : 0;
    return number.substr(sign, 1) == std::string_view(&point, 1);
  });
  FormatScore best;
  for (const int decimals : {0, 1}) {
    for (const int below : {-4, -6}) {
      for (const int from : {16, 6, 21}) {
        NumberFormat format = base;
        format.decimals = static_cast<std::uint8_t>(decimals);
        format.exponent_below = static_cast<std::int8_t>(below);
        format.exponent_from = static_cast<std::int8_t>(from);
        const int matches = count_matches(numbers, format);
        if (matches > best.matches) best = {format, matches};
      }
    }
  }
  return best;
}

/// At most `most` of the numbers, evenly taken.
Numbers thinned(const Numbers& numbers, int most) {
  const int step = std::max(1, (size_of(numbers) + most - 1) / most);
  Numbers result;
  for (int i = 0; i < size_of(numbers); i += step) result.push_back(numbers[idx(i)]);
  return result;
}

constexpr int kMostNumbersTried = 1024;

}  // namespace

int count_decimals(std::string_view number, char point) {
  if (has_exponent(number)) return -1;
  const std::size_t at = number.find(point);
  return at == std::string_view::npos ? 0 : size_of(number) - static_cast<int>(at) - 1;
}

NumberFormat guess_format(const Numbers& numbers, char point) {
  const NumberFormat fixed = usual_fixed_format(numbers, point);
  const int fixed_matches = count_matches(numbers, fixed);
  if (numbers.empty()) return {};
  if (fixed_matches == size_of(numbers)) return fixed;
  const Numbers some = thinned(numbers, kMostNumbersTried);
  const FormatScore shortest = best_shortest_format(some, point);
  return shortest.matches > count_matches(some, fixed) ? shortest.format : fixed;
}

std::vector<NumberFormat> guess_formats(const std::vector<Numbers>& rows, char point) {
  const std::size_t columns = rows.front().size();
  std::vector<NumberFormat> fixed;
  Numbers all;
  int fixed_matches = 0;
  for (std::size_t c = 0; c < columns; ++c) {
    Numbers column;
    for (const Numbers& row : rows) column.push_back(row[c]);
    fixed.push_back(usual_fixed_format(column, point));
    fixed_matches += count_matches(column, fixed.back());
    all.insert(all.end(), column.begin(), column.end());
  }
  if (fixed_matches == size_of(all)) return fixed;
  const FormatScore shortest = best_shortest_format(thinned(all, kMostNumbersTried), point);
  const int tried = size_of(thinned(all, kMostNumbersTried));
  const bool shortest_explains_more =
      static_cast<double>(shortest.matches) / tried > static_cast<double>(fixed_matches) / size_of(all);
  return shortest_explains_more ? std::vector<NumberFormat>(columns, shortest.format) : fixed;
}

}  // namespace marey
