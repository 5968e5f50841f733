#include "core/bvh/motion_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/bvh/joint_lines.h"
#include "core/bvh/keyword.h"
#include "core/bvh/row_text.h"

namespace marey {
namespace {

constexpr double kSlowestBelievable = 10.0;  ///< seconds per frame; from here on it is a rate in frames per second

/// True if one of the next lines begins with a keyword of the motion's header.
bool keyword_is_near(std::string_view text) {
  constexpr int kNear = 8;
  for (int i = 0; i < kNear && !text.empty(); ++i) {
    const std::string_view line = first_line(text);
    if (find_keyword(TextCursor(trimmed(line), 0).peek_word()) != Keyword::None) return true;
    text.remove_prefix(std::min(text.size(), line.size() + 1));
  }
  return false;
}

class MotionHeaderReader {
 public:
  MotionHeaderReader(TextCursor& cursor, int channel_count, Report& report)
      : cursor_(cursor), channel_count_(channel_count), report_(report) {}

  MotionHeader read();

 private:
  bool read_statement();
  bool starts_row(std::string_view word);
  void judge_line();
  void read_frame_count();
  void read_frame_time();
  void read_time_value(std::string_view word, std::size_t place);
  void report_repeat(DiagnosticCode code, std::size_t place, std::string_view keyword);
  void pass_colon(std::string_view keyword);
  void check_case(std::string_view right);
  void report_missing_parts();

  TextCursor& cursor_;
  int channel_count_;
  Report& report_;
  MotionHeader result_;
  std::optional<std::size_t> begin_;
  std::size_t line_end_ = 0;   ///< of the line that was judged last
  std::size_t row_begin_ = 0;  ///< where the first row begins in it, if it does
  bool has_keyword_ = false;
  bool has_frame_count_ = false;  ///< or something in its place, which has been reported
  bool has_frame_time_ = false;
};

MotionHeader MotionHeaderReader::read() {
  while (!report_.failed() && read_statement()) {
  }
  result_.data_begin = cursor_.offset();
  report_missing_parts();
  return result_;
}

/// False at the first sample and at the end.
bool MotionHeaderReader::read_statement() {
  skip_blanks_and_comments(cursor_, report_);
  if (cursor_.at_end()) return false;
  const std::size_t place = cursor_.offset();
  if (!begin_) begin_ = place;
  const std::string_view word = cursor_.peek_word();
  const Keyword keyword = find_keyword(word);
  if (keyword != Keyword::None) line_end_ = 0;  // what follows it is judged anew
  switch (keyword) {
    case Keyword::Motion:
      check_case("MOTION");
      has_keyword_ = true;
      return true;
    case Keyword::Frames: read_frame_count(); return true;
    case Keyword::Frame: read_frame_time(); return true;
    default: break;
  }
  if (starts_row(word)) return false;
  cursor_.take_word();
  result_.needs_printing = true;
  report_.add_each(DiagnosticCode::UnexpectedToken, place,
                   fmt::format("'{}' means nothing here and was left out.", shown(word)), "Frames: or Frame Time:",
                   shown(word));
  return true;
}

/// True if the word begins the first row, or stands there in place of a number.
bool MotionHeaderReader::starts_row(std::string_view word) {
  if (cursor_.offset() < line_end_) return cursor_.offset() >= row_begin_;
  if (starts_like_number(word)) return true;
  judge_line();
  return cursor_.offset() == row_begin_;
}

/// Judges a line that begins with a word: a row with a word in place of a number, words before a row, or text.
void MotionHeaderReader::judge_line() {
  const std::string_view line = first_line(cursor_.rest());
  int words = 0;
  int numbers = 0;
  int words_before_number = 0;
  std::size_t first_number = line.size();
  for (std::size_t at = 0; at < line.size(); at += gap_length(line.substr(at), {})) {
    const std::size_t length = value_length(line.substr(at), {});
    const bool is_number = starts_like_number(line.substr(at, length));
    if (is_number && numbers == 0) first_number = at;
    ++words;
    numbers += is_number ? 1 : 0;
    words_before_number += numbers == 0 ? 1 : 0;
    at += length;
  }
  line_end_ = cursor_.offset() + line.size();
  row_begin_ = line_end_;
  if (!has_frame_time_ && keyword_is_near(cursor_.rest())) return;
  if (words == channel_count_ && 2 * numbers >= words) {
    row_begin_ = cursor_.offset();
  } else if (words - words_before_number >= channel_count_) {
    row_begin_ = cursor_.offset() + first_number;
  }
}

/// Moves behind the letters of a keyword.
void MotionHeaderReader::check_case(std::string_view right) {
  const std::string_view found = cursor_.rest().substr(0, right.size());
  if (found != right) {
    report_.add(DiagnosticCode::KeywordCase, cursor_.offset(),
                fmt::format("'{}' was read as {}; many other programs want the format's spelling.", shown(found), right),
                std::string(right), shown(found));
  }
  cursor_.move_to(cursor_.offset() + found.size());
}

void MotionHeaderReader::pass_colon(std::string_view keyword) {
  cursor_.skip_blanks_in_line();
  if (cursor_.peek() == ':') {
    cursor_.move_to(cursor_.offset() + 1);
  } else {
    result_.needs_printing = true;
    report_.add_each(DiagnosticCode::UnexpectedToken, cursor_.offset(),
                     fmt::format("The colon behind {} is missing; it was added.", keyword), ":",
                     shown(cursor_.peek_word()));
  }
  cursor_.skip_blanks();
}

void MotionHeaderReader::read_frame_count() {
  constexpr double kLargestWhole = 9e15;
  const std::size_t begin = cursor_.offset();
  check_case("Frames");
  pass_colon("Frames");
  const std::string_view word = cursor_.peek_word();
  const NumberRead number = read_number(word);
  const bool whole = number.length > 0 && number.length == word.size() && number.value >= 0.0 &&
                     number.value <= kLargestWhole && number.value == std::floor(number.value);
  if (has_frame_count_) report_repeat(DiagnosticCode::RepeatedFrameCount, begin, "Frames:");
  has_frame_count_ = true;
  if (whole) {
    result_.declared_frames = static_cast<std::int64_t>(number.value);
    result_.frame_count_slot = {cursor_.offset(), word.size(), number.value};
  } else {
    result_.needs_printing = true;
    report_.add(DiagnosticCode::MissingFrameCount, cursor_.offset(),
                fmt::format("'{}' is not a frame count; the rows were counted instead.", shown(word)), "a whole number",
                shown(word));
  }
  if (starts_like_number(word)) cursor_.take_word();
}

void MotionHeaderReader::read_frame_time() {
  const std::size_t begin = cursor_.offset();
  check_case("Frame");
  cursor_.skip_blanks();
  if (equal_ignoring_case(cursor_.rest().substr(0, 4), "Time")) check_case("Time");
  pass_colon("Frame Time");
  const std::size_t place = cursor_.offset();
  const std::string_view word = cursor_.peek_word();
  if (!starts_like_number(word)) return;
  cursor_.take_word();
  if (has_frame_time_) report_repeat(DiagnosticCode::RepeatedFrameTime, begin, "Frame Time:");
  has_frame_time_ = true;
  read_time_value(word, place);
  result_.frame_time_slot = {place, word.size(), result_.frame_time_s};
}

void MotionHeaderReader::report_repeat(DiagnosticCode code, std::size_t place, std::string_view keyword) {
  result_.needs_printing = true;
  report_.add(code, place, fmt::format("'{}' stands here a second time; the last one is used.", keyword), "the first row",
              std::string(keyword));
}

void MotionHeaderReader::read_time_value(std::string_view word, std::size_t place) {
  const bool comma = word.find(',') != std::string_view::npos && word.find('.') == std::string_view::npos;
  const NumberRead number = read_number(word, comma ? ',' : '.');
  if (comma) {
    report_.add(DiagnosticCode::DecimalComma, place,
                fmt::format("'{}' has a decimal comma, which was read as a point.", shown(word)), "a decimal point",
                shown(word));
  }
  if (number.length != word.size() || !std::isfinite(number.value) || !(number.value > 0.0)) {
    result_.frame_time_s = MotionHeader().frame_time_s;
    report_.add(DiagnosticCode::FrameTimeNotPositive, place,
                fmt::format("Frame Time '{}' is no time; 1/30 of a second is used.", shown(word)),
                "seconds per frame", shown(word));
  } else if (number.value >= kSlowestBelievable) {
    result_.frame_time_s = 1.0 / number.value;
    report_.add(DiagnosticCode::FrameTimeLooksLikeRate, place,
                fmt::format("Frame Time {} looks like frames per second; 1/{} of a second is used.", shown(word), shown(word)),
                "seconds per frame", shown(word));
  } else {
    result_.frame_time_s = number.value;
  }
}

void MotionHeaderReader::report_missing_parts() {
  const std::size_t end = cursor_.offset();
  const bool has_rows = !cursor_.at_end();
  const bool has_part = has_frame_time_ || has_frame_count_;
  if (!has_keyword_) {
    result_.needs_printing = result_.needs_printing || has_part || has_rows;
    report_.add(DiagnosticCode::MissingMotion, begin_.value_or(end),
                has_part || has_rows ? "The word MOTION is missing; it was added."
                                     : "The file has no motion; the figure is shown in its rest pose.",
                "MOTION", begin_ ? "" : "the end of the file");
  } else if (!has_part && !has_rows) {
    report_.add(DiagnosticCode::MissingMotion, end,
                "Nothing stands behind MOTION; the figure is shown in its rest pose.", "Frames:", "the end of the file");
  }
  if (!has_part && !has_rows) return;
  if (!has_frame_count_) {
    result_.needs_printing = true;
    report_.add(DiagnosticCode::MissingFrameCount, end, "'Frames:' is missing; the rows were counted instead.", "Frames:",
                "");
  }
  if (!has_frame_time_) {
    result_.needs_printing = true;
    report_.add(DiagnosticCode::MissingFrameTime, end, "'Frame Time:' is missing; 1/30 of a second is used.",
                "Frame Time:", "");
  }
}

}  // namespace

bool starts_like_number(std::string_view word) {
  if (word.empty()) return false;
  const char first = word.front();
  return is_digit(first) || first == '-' || first == '+' || first == '.' || is_not_finite_text(word);
}

MotionHeader read_motion_header(TextCursor& cursor, int channel_count, Report& report) {
  return MotionHeaderReader(cursor, channel_count, report).read();
}

}  // namespace marey
