#include "core/bvh/joint_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/counted.h"
#include "core/base/index.h"
#include "core/base/number_text.h"
#include "core/bvh/keyword.h"

namespace marey {
namespace {

class OffsetReader {
 public:
  OffsetReader(TextCursor& cursor, Report& report) : cursor_(cursor), report_(report) {}

  OffsetRead read();

 private:
  bool read_value();
  void read_word_as_number(std::string_view word);
  void report_as_zero(std::string_view word, const NumberRead& number);
  void check_what_follows();
  void keep(std::size_t begin, std::size_t length, double value);

  TextCursor& cursor_;
  Report& report_;
  OffsetRead result_;
  bool bracketed_ = false;
  bool in_first_line_ = true;
};

bool is_bracket_or_comma(char c) { return c == '[' || c == ']' || c == '(' || c == ')' || c == ',' || c == ';'; }

bool starts_number(char c) { return is_digit(c) || c == '-' || c == '+' || c == '.'; }

/// "0,5": one comma with digits on both sides and no point.
bool has_decimal_comma(std::string_view word) {
  const std::size_t comma = word.find(',');
  return comma != std::string_view::npos && comma > 0 && is_digit(word[comma - 1]) && comma + 1 < word.size() &&
         is_digit(word[comma + 1]) && word.find(',', comma + 1) == std::string_view::npos &&
         word.find('.') == std::string_view::npos;
}

OffsetRead OffsetReader::read() {
  while (!report_.failed() && read_value()) {
  }
  return std::move(result_);
}

void OffsetReader::keep(std::size_t begin, std::size_t length, double value) {
  if (result_.count < kMostOffsetValues) result_.values.push_back({begin, length, value});
  ++result_.count;
}

bool OffsetReader::read_value() {
  cursor_.skip_blanks_in_line();
  if (is_line_end(cursor_.peek())) in_first_line_ = false;
  cursor_.skip_blanks();
  const std::size_t place = cursor_.offset();
  if (is_bracket_or_comma(cursor_.peek())) {
    bracketed_ = result_.repaired = true;
    report_.add(DiagnosticCode::OffsetBracketed, place,
                "The brackets and commas of this OFFSET were left out; BVH separates numbers by blanks.", "a number",
                std::string(1, cursor_.peek()));
    cursor_.move_to(place + 1);
    return true;
  }
  const std::string_view word = cursor_.peek_word();
  if (starts_number(cursor_.peek()) || is_not_finite_text(word)) {
    read_word_as_number(word);
    return true;
  }
  if (word.empty() || !in_first_line_ || result_.count >= 3 || find_keyword(word) != Keyword::None) return false;
  read_word_as_number(word);
  return true;
}

void OffsetReader::read_word_as_number(std::string_view word) {
  const std::size_t place = cursor_.offset();
  const bool comma = !bracketed_ && has_decimal_comma(word);
  const NumberRead number = read_number(word, comma ? ',' : '.');
  if (comma) {
    report_.add(DiagnosticCode::DecimalComma, place,
                fmt::format("'{}' has a decimal comma, which was read as a point.", shown(word)), "a decimal point",
                shown(word));
  }
  const bool is_word = is_not_finite_text(word) || number.length == 0;
  if (is_word || number.out_of_range) report_as_zero(word, number);
  if (is_word) {
    keep(place, word.size(), 0.0);
    cursor_.move_to(place + word.size());
    return;
  }
  const bool is_infinite = !std::isfinite(number.value);
  keep(place, number.length, is_infinite ? 0.0 : number.value);
  cursor_.move_to(place + number.length);
  check_what_follows();
}

/// A word, or a number that 64 bits cannot hold.
void OffsetReader::report_as_zero(std::string_view word, const NumberRead& number) {
  const std::size_t place = cursor_.offset();
  // Zero stays the reading of a number that is too small, so its text can stand.
  if (number.value != 0.0 || number.length == 0 || is_not_finite_text(word)) result_.repaired = true;
  if (is_not_finite_text(word)) {
    report_.add_each(DiagnosticCode::NotFinite, place, fmt::format("The offset '{}' was read as 0.", shown(word)),
                     "a finite number", shown(word));
  } else if (number.length == 0) {
    report_.add_each(DiagnosticCode::BadNumber, place, fmt::format("'{}' is not a number; 0 was used.", shown(word)),
                     "a number", shown(word));
  } else {
    report_.add_each(DiagnosticCode::NumberRange, place,
                     fmt::format("The offset '{}' does not fit into a number of 64 bits and was read as 0.", shown(word)),
                     "a number of 64 bits", shown(word));
  }
}

void OffsetReader::check_what_follows() {
  const std::size_t place = cursor_.offset();
  const char next = cursor_.peek();
  if (cursor_.at_end() || is_blank(next) || next == '{' || next == '}' || is_bracket_or_comma(next)) return;
  result_.repaired = true;
  if (next == '-' || next == '+') {
    report_.add(DiagnosticCode::NumbersRunTogether, place, "A blank is missing between two numbers; it was added.",
                "a blank", std::string(1, next));
    return;
  }
  const std::string_view rest = cursor_.peek_word();
  report_.add_each(DiagnosticCode::BadNumber, place,
                   fmt::format("'{}' behind the number was left out.", shown(rest)), "a blank", shown(rest));
  cursor_.move_to(place + rest.size());
}

/// The count behind CHANNELS, if there is one; moves behind it.
std::optional<double> take_count(TextCursor& cursor) {
  cursor.skip_blanks();
  const std::string_view word = cursor.peek_word();
  const NumberRead number = read_number(word);
  if (number.length == 0 || number.length != word.size()) return std::nullopt;
  cursor.take_word();
  if (number.value < 0.0 || number.value != std::floor(number.value)) return std::nullopt;
  return number.value;
}

void check_channel_spelling(const RawChannel& channel, std::size_t place, Report& report) {
  if (channel.kind == ChannelKind::Other) {
    report.add_each(DiagnosticCode::UnknownChannel, place,
                    fmt::format("Channel '{}' is not known; its values are kept but move nothing.", shown(channel.keyword)),
                    "Xposition ... Zrotation", shown(channel.keyword));
  } else if (channel.keyword != channel_keyword(channel.kind)) {
    report.add(DiagnosticCode::ChannelCase, place,
               fmt::format("'{}' was read as {}; many other programs want the format's spelling.",
                           shown(channel.keyword), channel_keyword(channel.kind)),
               std::string(channel_keyword(channel.kind)), shown(channel.keyword));
  }
}

}  // namespace

OffsetRead read_offset_values(TextCursor& cursor, Report& report) { return OffsetReader(cursor, report).read(); }

ChannelsRead read_channel_names(TextCursor& cursor, int most, Report& report) {
  ChannelsRead read;
  const std::size_t begin = cursor.offset();
  const std::optional<double> declared = take_count(cursor);
  while (!report.failed() && size_of(read.channels) < most) {
    skip_blanks_and_comments(cursor, report);
    const std::size_t place = cursor.offset();
    const std::string_view word = cursor.peek_word();
    const auto kind = find_channel_kind(word);
    const bool wanted = size_of(read.channels) < declared.value_or(0.0);
    if (word.empty() || (!kind && (!wanted || find_keyword(word) != Keyword::None))) break;
    cursor.take_word();
    read.channels.push_back({kind.value_or(ChannelKind::Other), word});
    check_channel_spelling(read.channels.back(), place, report);
  }
  if (declared == static_cast<double>(read.channels.size())) return read;
  const std::string found = counted(size_of(read.channels), "channel");
  read.repaired = true;
  report.add_each(DiagnosticCode::ChannelCountMismatch, begin,
                  fmt::format("CHANNELS announces {} and names {}; the names are used.",
                              declared ? fmt::format("{}", *declared) : std::string("no usable count"), found),
                  fmt::format("{}", declared.value_or(0.0)), found);
  return read;
}

void skip_blanks_and_comments(TextCursor& cursor, Report& report) {
  for (;;) {
    cursor.skip_blanks();
    const std::string_view start = cursor.rest().substr(0, 2);
    if (start.substr(0, 1) != "#" && start != "//") return;
    const std::size_t place = cursor.offset();
    const std::string_view comment = cursor.skip_line();
    if (report.count_repeat(DiagnosticCode::Comment)) continue;
    report.add(DiagnosticCode::Comment, place,
               fmt::format("The comment '{}' is kept; most other programs stumble over comments.", shown(comment)), "",
               shown(comment));
  }
}

}  // namespace marey
