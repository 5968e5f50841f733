#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/counted.h"
#include "core/bvh/keyword.h"
#include "core/bvh/motion_header.h"
#include "core/bvh/row_reader.h"

namespace marey {
namespace {

/// True if each of the next `most` words, as far as there are so many, can be a number.
bool holds_only_numbers(std::string_view text, int most, const NumberLook& look) {
  for (int i = 0; i < most; ++i) {
    text.remove_prefix(gap_length(text, look));
    if (text.empty()) return true;
    const std::size_t length = value_length(text, look);
    if (!starts_like_number(text.substr(0, length))) return false;
    text.remove_prefix(length);
  }
  return true;
}

int count_numbers(std::string_view line, const NumberLook& look) {
  int count = 0;
  for (line.remove_prefix(gap_length(line, look)); !line.empty(); line.remove_prefix(gap_length(line, look))) {
    const std::size_t length = value_length(line, look);
    count += starts_like_number(line.substr(0, length)) ? 1 : 0;
    line.remove_prefix(length);
  }
  return count;
}

bool opens_another_section(std::string_view word) {
  const Keyword keyword = find_keyword(word);
  return keyword == Keyword::Hierarchy || keyword == Keyword::Root || keyword == Keyword::Motion || keyword == Keyword::Frames;
}

}  // namespace

/// False when there are no more rows.
bool RowReader::read_irregular_row() {
  bool line_ends = false;
  const char* p = skip_gap(at_, line_ends);
  if (report_.failed() || p == end_) return false;
  const bool within_line = frames() > 0 && !line_ends && survey_.layout != RowLayout::Stream;
  const bool shares_line = within_line && offset_of(p) < shared_line_end_;
  if (within_line && !shares_line && settle_line_remainder(p)) return true;
  if (ends_here(p)) return false;
  const RowPlan plan = plan_row(p, within_line);
  if (plan.partial) {
    drop_partial_row(plan, p);
    return false;
  }
  if (!plan.regular) report_row_length(p, count_values(first_line(rest(p)), survey_.look));
  if (report_.failed()) return false;
  read_values(p, plan);
  return true;
}

/// Passes separators and, as long as frames are expected, comments and lines of text.
const char* RowReader::skip_gap(const char* p, bool& line_ends) {
  for (;;) {
    const std::string_view gap = rest(p).substr(0, gap_length(rest(p), survey_.look));
    line_ends = line_ends || has_line_end(gap);
    p += gap.size();
    if (p == end_ || all_declared_read()) return p;
    const std::string_view comment = rest(p).substr(0, comment_length(rest(p)));
    if (comment.empty() && !(line_ends && is_text_between_rows(p))) return p;
    const std::string_view passed = comment.empty() ? first_line(rest(p)) : comment;
    report_passed_text(p, passed, !comment.empty());
    p += passed.size();
  }
}

/// True if the line at `p` begins with a word and is no row, by its length or for want of numbers, while a row follows within a few lines.
bool RowReader::is_text_between_rows(const char* p) const {
  constexpr int kMostLines = 8;
  std::string_view left = rest(p);
  if (survey_.layout == RowLayout::Stream || starts_like_number(word_at(p))) return false;
  const std::string_view first = first_line(left);
  if (count_values(first, survey_.look) == channel_count_ && 2 * count_numbers(first, survey_.look) >= channel_count_) return false;
  for (int i = 0; i < kMostLines && !left.empty(); ++i) {
    const std::string_view line = first_line(left);
    const std::string_view words = line.substr(std::min(line.size(), gap_length(line, survey_.look)));
    if (opens_another_section(TextCursor(words, 0).peek_word())) return false;
    const int count = count_values(words, survey_.look);
    const bool fits = count == channel_count_ || count == survey_.values_per_line;
    if (count > 0 && starts_like_number(words.substr(0, value_length(words, survey_.look)))) {
      return fits && holds_only_numbers(words, count, survey_.look);
    }
    left = behind_first_line(left);
  }
  return false;
}

void RowReader::report_passed_text(const char* p, std::string_view text, bool is_comment) {
  const DiagnosticCode code = is_comment ? DiagnosticCode::Comment : DiagnosticCode::UnexpectedToken;
  if (report_.count_repeat(code)) return;
  report_.add(code, offset_of(p),
              is_comment ? fmt::format("The comment '{}' is kept; most other programs stumble over comments.", shown(text))
                         : fmt::format("The line '{}' between the rows is no row; it was passed over and is kept.", shown(text)),
              is_comment ? "" : "a row", shown(text));
}

/// True if what stands at `p`, where a row may begin, is not a row but text behind the motion.
bool RowReader::ends_here(const char* p) {
  if (!starts_like_number(word_at(p))) {
    const bool may_be_row = input_.declared_frames ? !all_declared_read() : frames() == 0;
    return !may_be_row || count_values(first_line(rest(p)), survey_.look) != channel_count_;
  }
  if (!all_declared_read()) return false;
  if (survey_.layout == RowLayout::Stream) return !holds_only_numbers(rest(p), channel_count_, survey_.look);
  const std::string_view line = first_line(rest(p));
  const int count = count_values(line, survey_.look);
  const bool cut_off = count < channel_count_ && trimmed(rest(p + line.size())).empty();
  const bool fits = count % channel_count_ == 0 || count == survey_.values_per_line || cut_off;
  return !fits || !holds_only_numbers(line, count, survey_.look) || !surplus_rows_are_frames(p);
}

/// Judges the lines of numbers behind the declared frames: frames, if more of them fit the channels, from the first one
/// on, than there are others behind. Lists of varying length, in which one fits by chance, are not.
bool RowReader::surplus_rows_are_frames(const char* p) {
  if (keeps_surplus_rows_) return *keeps_surplus_rows_;
  int fitting = 0;
  int others = 0;
  std::string_view left = rest(p);
  while (!left.empty()) {
    const std::string_view line = first_line(left);
    const int count = count_values(line, survey_.look);
    const bool fits = count % channel_count_ == 0 || count == survey_.values_per_line;
    const bool is_last = trimmed(left.substr(line.size())).empty();
    if (count > 0 && holds_only_numbers(line, count, survey_.look)) {
      if (fits && others == 0) ++fitting;
      if (!fits && !is_last) ++others;
      if (!fits && is_last && count > channel_count_) ++others;
    }
    left = behind_first_line(left);
  }
  keeps_surplus_rows_ = fitting > others || others == 0;
  return *keeps_surplus_rows_;
}

/// Values stand behind a complete row in its line. Either they are whole frames, or they are left out (true). Behind the
/// last declared row they can also be text, which begins with a word.
bool RowReader::settle_line_remainder(const char* p) {
  const std::string_view line = first_line(rest(p));
  const int count = count_values(line, survey_.look);
  if (count == 0 || (all_declared_read() && !holds_only_numbers(line, count, survey_.look))) return false;
  if (survey_.layout == RowLayout::LinePerFrame && count % channel_count_ == 0) {
    shared_line_end_ = offset_of(line.data() + line.size());
    return false;
  }
  repaired_ = true;
  report_row_length(p, channel_count_ + count);
  at_ = line.data() + line.size();
  return true;
}

RowReader::RowPlan RowReader::plan_row(const char* p, bool shares_line) {
  if (survey_.layout == RowLayout::Stream) return plan_stream_row(p);
  RowPlan plan;
  plan.value_count = channel_count_;
  if (shares_line) return plan;
  const std::string_view line = first_line(rest(p));
  const int count = count_values(line, survey_.look);
  if (count == channel_count_) return plan;
  if (count < channel_count_) return plan_short_line(p, count);
  if (survey_.layout == RowLayout::LinePerFrame && count % channel_count_ == 0) {
    shared_line_end_ = offset_of(line.data() + line.size());
    return plan;
  }
  plan.regular = false;
  plan.drop_to = line.data() + line.size();
  return plan;
}

/// A line with too few values goes on in the next lines, is the cut end of the file, or lacks values.
RowReader::RowPlan RowReader::plan_short_line(const char* p, int count) {
  RowPlan plan;
  plan.value_count = count;
  int sum = count;
  std::string_view behind = rest(p);
  while (sum < channel_count_) {
    behind.remove_prefix(first_line(behind).size());
    behind.remove_prefix(gap_length(behind, survey_.look));
    if (behind.empty() || !starts_like_number(behind.substr(0, value_length(behind, survey_.look)))) break;
    const int next = count_values(first_line(behind), survey_.look);
    if (next >= channel_count_) break;
    sum += next;
  }
  const bool nothing_follows = sum == count && trimmed(rest(p + first_line(rest(p)).size())).empty();
  const bool usual = survey_.layout == RowLayout::CutLines && count == survey_.values_per_line;
  if (sum == channel_count_ && survey_.layout == RowLayout::LinePerFrame) {
    plan.value_count = channel_count_;
  } else if (nothing_follows && !usual) {
    plan.partial = true;
  } else {
    plan.regular = false;
    plan.drop_to = p + first_line(rest(p)).size();
  }
  return plan;
}

RowReader::RowPlan RowReader::plan_stream_row(const char* p) {
  RowPlan plan;
  std::string_view left = rest(p);
  while (plan.value_count < channel_count_) {
    left.remove_prefix(gap_length(left, survey_.look));
    if (left.empty()) break;
    const bool comment = starts_comment(left) && !all_declared_read();
    left.remove_prefix(comment ? comment_length(left) : value_length(left, survey_.look));
    plan.value_count += comment ? 0 : 1;
  }
  plan.partial = plan.value_count < channel_count_;
  return plan;
}

void RowReader::read_values(const char* p, const RowPlan& plan) {
  repaired_ = repaired_ || !plan.regular;
  double* row = store_.next_row();
  const std::int64_t first_index = frames() * channel_count_;
  const char* gap_begin = frames() == 0 ? p : at_;
  for (int channel = 0; channel < plan.value_count; ++channel) {
    bool line_ends = false;
    const char* begin = channel == 0 ? p : skip_gap(gap_begin, line_ends);
    bool kept_as_written = plan.regular;
    const char* end = read_value(begin, channel, row[channel], kept_as_written);
    const std::string_view gap(gap_begin, static_cast<std::size_t>(begin - gap_begin));
    const std::string_view number(begin, static_cast<std::size_t>(end - begin));
    const bool opens_rows = frames() == 0 && channel == 0;
    if (kept_as_written && !text_is_predicted(channel, row[channel], opens_rows ? survey_.columns[0].gap : gap, number)) {
      odd_tokens_.add(first_index + channel, row[channel], gap, number);
    }
    gap_begin = end;
  }
  std::copy_n(store_.previous_row() + plan.value_count, channel_count_ - plan.value_count, row + plan.value_count);
  at_ = plan.drop_to != nullptr ? plan.drop_to : gap_begin;
  store_.commit_row();
}

/// Reads what stands at `p` as a number, whatever it is; gives its end. `kept_as_written` becomes false where the text
/// does not say what was read.
const char* RowReader::read_value(const char* p, int channel, double& value, bool& kept_as_written) {
  const std::string_view word = word_at(p);
  const NumberRead number = read_number(word, survey_.look.point);
  const char* end = p + word.size();
  if (number.length == word.size() && std::isfinite(number.value)) {
    value = number.value;
    if (number.out_of_range && !report_.count_repeat(DiagnosticCode::NumberRange)) {
      report_.add(DiagnosticCode::NumberRange, offset_of(p),
                  fmt::format("'{}' is too small for a number of 64 bits and was read as 0.", shown(word)), "",
                  shown(word));
    }
    if (end != end_ && !is_separator(*end, survey_.look) && !report_.count_repeat(DiagnosticCode::NumbersRunTogether)) {
      report_.add(DiagnosticCode::NumbersRunTogether, offset_of(end),
                  "A blank is missing between two numbers; they were told apart by the sign.", "a blank",
                  shown(word_at(end)));
    }
    return end;
  }
  kept_as_written = false;
  const bool number_is_too_large = number.length == word.size();
  const DiagnosticCode not_a_number = is_not_finite_text(word) ? DiagnosticCode::NotFinite : DiagnosticCode::BadNumber;
  value = replace_value(p, word, channel, number_is_too_large ? DiagnosticCode::NumberRange : not_a_number);
  return end;
}

/// The value for a word that is none: that of the frame before.
double RowReader::replace_value(const char* p, std::string_view word, int channel, DiagnosticCode code) {
  repaired_ = true;
  if (!report_.count_repeat(code)) {
    report_.add(code, offset_of(p),
                fmt::format("'{}' is not a usable number; the value of the frame before was taken (0 in the first frame).",
                            shown(word)),
                "a number", shown(word));
  }
  return store_.previous_row()[channel];
}

void RowReader::drop_partial_row(const RowPlan& plan, const char* p) {
  repaired_ = true;
  report_.add(DiagnosticCode::PartialFrame, offset_of(p),
              fmt::format("The last row has {} of {} values; it was dropped.", plan.value_count, channel_count_),
              counted(channel_count_, "value"), counted(plan.value_count, "value"));
  at_ = rest(p).data() + trimmed(rest(p)).size();
}

void RowReader::report_row_length(const char* p, int found) {
  const bool surplus = found > channel_count_;
  const bool usual = survey_.layout == RowLayout::CutLines;
  const DiagnosticCode code = surplus && usual ? DiagnosticCode::SurplusValues : DiagnosticCode::RowLength;
  if (report_.count_repeat(code)) return;
  const std::string_view repair = surplus ? "the surplus ones were left out"
                                          : "the missing ones were taken from the frame before (0 in the first frame)";
  report_.add(code, offset_of(p),
              fmt::format("This row has {} for {}; {}.", counted(found, "value"), counted(channel_count_, "channel"), repair),
              counted(channel_count_, "value"), counted(found, "value"));
}

}  // namespace marey
