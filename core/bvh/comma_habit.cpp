#include "core/bvh/comma_habit.h"

#include <algorithm>

#include "core/base/byte_search.h"
#include "core/base/index.h"
#include "core/base/number_text.h"
#include "core/bvh/motion_header.h"

namespace marey {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20;
constexpr int kMostLines = 32;
constexpr NumberLook kPlain{'.', false, false};
constexpr NumberLook kDecimal{',', false, false};
constexpr NumberLook kSeparated{'.', true, false};
constexpr NumberLook kDecimalAndSemicolons{',', false, true};

using Lines = std::vector<std::string_view>;

bool has_comma(std::string_view text) { return find_either(text, ',', ';') != std::string_view::npos; }

template <class Visit>
void for_each_word(std::string_view line, Visit visit, const NumberLook& look = kPlain) {
  for (;;) {
    line.remove_prefix(gap_length(line, look));
    if (line.empty()) return;
    const std::size_t length = value_length(line, look);
    visit(line.substr(0, length));
    line.remove_prefix(length);
  }
}

/// True if at least half of the words can be numbers.
bool is_row_like(std::string_view line) {
  int words = 0;
  int numbers = 0;
  for_each_word(line, [&](std::string_view word) {
    ++words;
    numbers += starts_like_number(word) ? 1 : 0;
  });
  return numbers > 0 && 2 * numbers >= words;
}

/// Rows with commas, from the first one on.
Lines find_comma_lines(std::string_view rows) {
  Lines lines;
  const std::size_t first = find_either(rows, ',', ';');
  if (first == std::string_view::npos) return lines;
  const std::size_t line_end = find_last_line_end(rows.substr(0, first));
  rows = rows.substr(line_end == std::string_view::npos ? 0 : line_end + 1, kMostBytes);
  while (!rows.empty() && size_of(lines) < kMostLines) {
    const std::string_view line = first_line(rows);
    if (has_comma(line) && !starts_comment(trimmed(line)) && is_row_like(line)) lines.push_back(line);
    rows = behind_first_line(rows);
  }
  return lines;
}

/// What the words of some lines look like.
struct WordCensus {
  int pointed = 0;       ///< "1.5"
  int decimal_like = 0;  ///< "1,5"
  int separating = 0;    ///< commas that are no decimal signs: "1,", "1.5,2", "1,2,3"
};

bool is_decimal_like(std::string_view word) {
  const NumberRead number = read_number(word, ',');
  return number.length == word.size() && is_digit(word.back());
}

void count_words(std::string_view line, WordCensus& census) {
  for_each_word(line, [&](std::string_view word) {
    if (word.find_first_not_of(',') == std::string_view::npos) ++census.separating;
    if (!starts_like_number(word) || is_not_finite_text(word)) return;
    const std::size_t point = word.find('.');
    census.pointed += point != std::string_view::npos && read_number(word).length > point ? 1 : 0;
    if (!has_comma(word)) return;
    ++(is_decimal_like(word) ? census.decimal_like : census.separating);
  });
}

/// True if semicolons stand between numbers that have decimal commas and never points: "1,5;2,5".
bool has_semicolons_between_decimals(const Lines& lines, int channel_count) {
  bool plausible = true;
  int decimals = 0;
  int fitting = 0;
  for (const std::string_view line : lines) {
    plausible = plausible && line.find(';') != std::string_view::npos && line.find('.') == std::string_view::npos;
    fitting += count_values(line, kDecimalAndSemicolons) % channel_count == 0 ? 1 : 0;
    for_each_word(line, [&](std::string_view word) { decimals += has_comma(word) && is_decimal_like(word) ? 1 : 0; },
                  kDecimalAndSemicolons);
  }
  return plausible && decimals > 0 && 2 * fitting > size_of(lines);
}

/// How well the rows fit the channels when their commas are understood in one way.
int fit_of(const NumberLook& look, std::string_view rows, const Lines& comma_lines, int channel_count,
           std::optional<std::int64_t> declared) {
  if (declared && take_census(rows, look).values == *declared * channel_count) return kMostLines + 1;
  return static_cast<int>(std::count_if(comma_lines.begin(), comma_lines.end(), [&](std::string_view line) {
    return count_values(line, look) % channel_count == 0;
  }));
}

}  // namespace

std::vector<std::string_view> find_value_lines(std::string_view rows, int channel_count, int most) {
  Lines lines;
  rows = rows.substr(0, kMostBytes);
  while (!rows.empty() && size_of(lines) < most) {
    const std::string_view line = first_line(rows);
    const bool cut_by_limit = line.size() == rows.size() && rows.size() == kMostBytes;
    const std::string_view content = trimmed(line);
    const bool begins_with_number = starts_like_number(content.substr(0, content.find_first_of(" \t")));
    const bool is_row = begins_with_number || (is_row_like(content) && count_values(content, kPlain) == channel_count);
    if (!content.empty() && !is_row) break;
    if (!content.empty() && !(cut_by_limit && !lines.empty())) lines.push_back(line);
    rows = behind_first_line(rows);
  }
  return lines;
}

RowCensus take_census(std::string_view rows, const NumberLook& look) {
  RowCensus census;
  while (!rows.empty()) {
    const std::string_view line = first_line(rows);
    const int values = count_values(line, look);
    census.lines += values > 0 ? 1 : 0;
    census.values += values;
    rows = behind_first_line(rows);
  }
  return census;
}

NumberLook find_comma_habit(std::string_view rows, const std::vector<std::string_view>& first_lines, int channel_count,
                            std::optional<std::int64_t> declared_frames) {
  const Lines comma_lines = find_comma_lines(rows);
  if (comma_lines.empty()) return kPlain;
  if (has_semicolons_between_decimals(comma_lines, channel_count)) return kDecimalAndSemicolons;
  WordCensus census;
  for (const std::string_view line : comma_lines) count_words(line, census);
  for (const std::string_view line : first_lines) {
    if (!has_comma(line)) count_words(line, census);
  }
  const auto fit = [&](const NumberLook& look) { return fit_of(look, rows, comma_lines, channel_count, declared_frames); };
  const int separated_fit = fit(kSeparated);
  if (census.decimal_like > census.pointed && fit(kDecimal) >= separated_fit) return kDecimal;
  const bool could_be_decimal = census.separating == 0 && census.pointed > 0;
  if (could_be_decimal || fit(kPlain) > separated_fit) return kPlain;
  const bool among_first =
      std::any_of(first_lines.begin(), first_lines.end(), [](std::string_view line) { return has_comma(line) && is_row_like(line); });
  return separated_fit > 0 || among_first ? kSeparated : kPlain;
}

}  // namespace marey
