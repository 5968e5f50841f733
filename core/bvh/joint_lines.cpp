#include "core/bvh/joint_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/counted.h"
#include "core/base/index.h"
#include "core/base/number_text.h"
#include "core/bvh/keyword.h"
#include "core/bvh/row_text.h"

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

/// Commas, colons, quotes and brackets, which some files have around the names of channels.
bool is_name_mark(char c) {
  return c == ',' || c == ';' || c == ':' || c == '"' || c == '\'' || c == '[' || c == ']' || c == '(' || c == ')';
}

bool is_bracket_or_comma(char c) { return c == '[' || c == ']' || c == '(' || c == ')' || c == ',' || c == ';' || c == '='; }

/// A digit or point, maybe behind a sign.
bool starts_number(std::string_view word) {
  if (!word.empty() && (word.front() == '-' || word.front() == '+')) word.remove_prefix(1);
  return !word.empty() && (is_digit(word.front()) || word.front() == '.');
}

/// "0,5": one comma with digits on both sides and no point.
bool has_decimal_comma(std::string_view word) {
  const std::size_t comma = word.find(',');
  return comma != std::string_view::npos && comma > 0 && is_digit(word[comma - 1]) && comma + 1 < word.size() &&
         is_digit(word[comma + 1]) && word.find(',', comma + 1) == std::string_view::npos &&
         word.find('.') == std::string_view::npos;
}

OffsetRead OffsetReader::read() {
  result_.end = cursor_.offset();
  while (!report_.failed() && read_value()) {
  }
  return std::move(result_);
}

void OffsetReader::keep(std::size_t begin, std::size_t length, double value) {
  if (result_.count < kMostOffsetValues) result_.values.push_back({begin, length, value});
  result_.end = begin + length;
  ++result_.count;
}

bool OffsetReader::read_value() {
  cursor_.skip_blanks_in_line();
  if (is_line_end(cursor_.peek())) in_first_line_ = false;
  cursor_.skip_blanks();
  const std::size_t place = cursor_.offset();
  if (cursor_.peek() == ';' && result_.count >= 3) return false;
  if (result_.count < 3 && cursor_.peek() != ';' && starts_comment(cursor_.rest())) {
    skip_blanks_and_comments(cursor_, report_);
    return true;
  }
  if (is_bracket_or_comma(cursor_.peek())) {
    bracketed_ = true;
    result_.patches.remove(place, 1);
    report_.add(DiagnosticCode::OffsetBracketed, place,
                "The brackets and commas of this OFFSET were left out; BVH separates numbers by blanks.", "a number",
                std::string(1, cursor_.peek()));
    cursor_.move_to(place + 1);
    return true;
  }
  const std::string_view word = cursor_.peek_word();
  if (starts_number(word) || is_not_finite_text(word)) {
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
  const bool is_word = number.length == 0 || is_not_finite_text(word);
  if (is_word || number.value != 0.0) result_.patches.replace(place, is_word ? word.size() : number.length, "0");
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
  if (next == '-' || next == '+') {
    result_.patches.insert(place, " ");
    report_.add(DiagnosticCode::NumbersRunTogether, place, "A blank is missing between two numbers; it was added.",
                "a blank", std::string(1, next));
    return;
  }
  const std::string_view rest = cursor_.peek_word();
  result_.patches.remove(place, rest.size());
  report_.add_each(DiagnosticCode::BadNumber, place,
                   fmt::format("'{}' behind the number was left out.", shown(rest)), "a blank", shown(rest));
  cursor_.move_to(place + rest.size());
}

/// What stands in place of the count behind CHANNELS.
struct CountRead {
  std::optional<double> value;
  std::size_t begin = 0;
  std::size_t length = 0;  ///< 0: nothing stands there
};

/// Reads the count, if there is one, and moves behind it: also behind "3," and before the name in "3Zrotation".
CountRead take_count(TextCursor& cursor) {
  cursor.skip_blanks();
  const std::string_view word = cursor.peek_word();
  const NumberRead number = read_number(word);
  const std::string_view behind = word.substr(number.length);
  const bool is_count = number.length > 0 && (behind.empty() || is_name_mark(behind.front()) || find_channel_kind(behind));
  if (!is_count) return {};
  CountRead read{std::nullopt, cursor.offset(), number.length};
  cursor.move_to(read.begin + read.length);
  if (number.value >= 0.0 && number.value == std::floor(number.value)) read.value = number.value;
  return read;
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

/// "Zrotation," of "Zrotation,Xrotation": up to and with the marks behind the first name of several known ones.
std::string_view first_of_glued_names(std::string_view word) {
  const auto is_mark = [](char c) { return is_name_mark(c); };
  const auto name = std::find_if_not(word.begin(), word.end(), is_mark);
  const auto mark = std::find_if(name, word.end(), is_mark);
  const auto next = std::find_if_not(mark, word.end(), is_mark);
  if (next == word.end()) return word;
  const std::string_view first(word.data() + (name - word.begin()), static_cast<std::size_t>(mark - name));
  return find_channel_kind(first) ? word.substr(0, static_cast<std::size_t>(next - word.begin())) : word;
}

class ChannelsReader {
 public:
  ChannelsReader(TextCursor& cursor, Report& report) : cursor_(cursor), report_(report) {}

  ChannelsRead read(int most);

 private:
  bool read_name(double declared);

  TextCursor& cursor_;
  Report& report_;
  std::size_t word_end_ = 0;  ///< of the word that is being read
  ChannelsRead result_;
};

ChannelsRead ChannelsReader::read(int most) {
  const std::size_t begin = cursor_.offset();
  const CountRead count = take_count(cursor_);
  result_.end = cursor_.offset();
  while (!report_.failed() && size_of(result_.channels) < most && read_name(count.value.value_or(0.0))) {
  }
  if (count.value == static_cast<double>(result_.channels.size())) return std::move(result_);
  const std::string found = counted(size_of(result_.channels), "channel");
  const std::string right = std::to_string(result_.channels.size());
  if (count.length > 0) {
    result_.patches.replace(count.begin, count.length, right);
  } else {
    result_.patches.insert(begin, " " + right);
  }
  report_.add_each(DiagnosticCode::ChannelCountMismatch, begin,
                   fmt::format("CHANNELS announces {} and names {}; the names are used.",
                               count.value ? fmt::format("{}", *count.value) : std::string("no usable count"), found),
                   fmt::format("{}", count.value.value_or(0.0)), found);
  return std::move(result_);
}

/// False if no further name stands here.
bool ChannelsReader::read_name(double declared) {
  skip_blanks_and_comments(cursor_, report_);
  const std::size_t begin = cursor_.offset();
  // Measured once for all names that are glued to one word.
  if (begin >= word_end_) word_end_ = begin + cursor_.peek_word().size();
  const std::string_view whole = first_of_glued_names(cursor_.text().substr(begin, word_end_ - begin));
  std::string_view word = whole;
  while (!word.empty() && is_name_mark(word.front())) word.remove_prefix(1);
  while (!word.empty() && is_name_mark(word.back())) word.remove_suffix(1);
  const auto kind = find_channel_kind(word);
  const bool wanted = size_of(result_.channels) < declared;
  const bool only_marks = word.empty() && !whole.empty() && wanted;
  if (!only_marks && (word.empty() || (!kind && (!wanted || find_keyword(whole) != Keyword::None)))) return false;
  cursor_.move_to(begin + whole.size());
  if (whole.size() != word.size()) {
    const bool is_glued = !cursor_.at_end() && !is_blank(cursor_.peek());
    result_.patches.replace(begin, whole.size(), std::string(word) + (is_glued ? " " : ""));
    report_.add(DiagnosticCode::UnexpectedToken, begin,
                fmt::format("The marks around the channel in '{}' were left out.", shown(whole)), "a channel", shown(whole));
  }
  result_.end = cursor_.offset();
  if (only_marks) return true;
  if (is_digit(cursor_.text()[begin - 1])) {
    result_.patches.insert(begin, " ");
    report_.add(DiagnosticCode::UnexpectedToken, begin, "The blank behind the number of channels is missing; it was added.",
                "a blank", shown(whole));
  }
  result_.channels.push_back({kind.value_or(ChannelKind::Other), word});
  check_channel_spelling(result_.channels.back(), begin, report_);
  return true;
}

}  // namespace

OffsetRead read_offset_values(TextCursor& cursor, Report& report) { return OffsetReader(cursor, report).read(); }

ChannelsRead read_channel_names(TextCursor& cursor, int most, Report& report) {
  return ChannelsReader(cursor, report).read(most);
}

void pass_blanks_and_comments(TextCursor& cursor) {
  for (;;) {
    cursor.skip_blanks();
    const std::size_t length = comment_length(cursor.rest());
    if (length == 0) return;
    cursor.move_to(cursor.offset() + length);
  }
}

void skip_blanks_and_comments(TextCursor& cursor, Report& report) {
  for (;;) {
    cursor.skip_blanks();
    const std::size_t place = cursor.offset();
    const std::string_view comment = cursor.rest().substr(0, comment_length(cursor.rest()));
    if (comment.empty()) return;
    cursor.move_to(place + comment.size());
    if (report.count_repeat(DiagnosticCode::Comment)) continue;
    report.add(DiagnosticCode::Comment, place,
               fmt::format("The comment '{}' is kept; most other programs stumble over comments.", shown(comment)), "",
               shown(comment));
  }
}

}  // namespace marey
