#include "core/bvh/motion_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/bvh/frame_time_text.h"
#include "core/bvh/joint_lines.h"
#include "core/bvh/keyword.h"
#include "core/bvh/keyword_reader.h"
#include "core/bvh/row_text.h"
#include "core/motion/frame_time.h"

namespace marey {
namespace {

/// True if one of the next lines begins with a keyword of the motion's header.
bool keyword_is_near(std::string_view text) {
  constexpr int kNear = 8;
  for (int i = 0; i < kNear && !text.empty(); ++i) {
    const std::string_view line = first_line(text);
    if (find_keyword(TextCursor(trimmed(line), 0).peek_word()) != Keyword::None) return true;
    text = behind_first_line(text);
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
  [[nodiscard]] bool ends_without_rows() const;
  bool starts_row(std::string_view word);
  void judge_line();
  void skip_unknown_word();
  void read_frame_count(std::size_t begin);
  bool read_frame_line();
  void read_frame_time(std::size_t begin);
  void read_frame_rate(std::size_t begin);
  void read_as(const std::string& keyword, std::size_t begin);
  void leave_line_out(std::size_t begin);
  bool value_is_missing() const;
  void report_repeat(DiagnosticCode code, std::size_t place, std::string_view keyword);
  void pass_colon(std::string_view keyword);
  void check_case(std::string_view right);
  void report_missing_parts();
  void report_missing_motion(bool has_part, bool has_rows);

  /// From the keyword to the value of the line that was read last.
  struct Line {
    std::size_t begin = 0;
    std::size_t end = 0;
  };

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
  Line count_line_;
  Line time_line_;
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
  if (cursor_.at_end() || ends_without_rows()) return false;
  const std::size_t place = cursor_.offset();
  if (!begin_) begin_ = place;
  const std::string_view word = cursor_.peek_word();
  const Keyword keyword = find_keyword(word);
  if (keyword != Keyword::None) line_end_ = 0;  // what follows it is judged anew
  switch (keyword) {
    case Keyword::Motion:
      take_keyword(cursor_, keyword, result_.patches, report_);
      has_keyword_ = true;
      return true;
    case Keyword::Frames:
      check_case("Frames");
      read_frame_count(place);
      return true;
    case Keyword::Frame:
      if (read_frame_line()) return true;
      break;
    default: break;
  }
  if (!has_keyword_ && keyword == Keyword::None && find_misspelled_keyword(word) == Keyword::Motion) {
    take_keyword(cursor_, Keyword::Motion, result_.patches, report_);
    has_keyword_ = true;
    return true;
  }
  if (starts_row(word)) return false;
  skip_unknown_word();
  return true;
}

/// Without channels there is no row that could end the header: all that follows its last part is text.
bool MotionHeaderReader::ends_without_rows() const {
  return channel_count_ == 0 && has_keyword_ && has_frame_count_ && has_frame_time_;
}

/// "FPS: 25" is a frame rate; anything else is left out.
void MotionHeaderReader::skip_unknown_word() {
  const std::size_t place = cursor_.offset();
  const std::string_view word = cursor_.take_word();
  std::string_view letters = word;
  while (!letters.empty() && is_keyword_punctuation(letters.back())) letters.remove_suffix(1);
  if (equal_ignoring_case(letters, "FPS") && !has_frame_time_) {
    cursor_.move_to(place + letters.size());
    read_frame_rate(place);
    return;
  }
  result_.patches.remove(place, word.size());
  report_.add_each(DiagnosticCode::UnexpectedToken, place,
                   fmt::format("'{}' means nothing here and was left out.", shown(word)), "Frames: or Frame Time:",
                   shown(word));
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

/// Passes the colon, and blanks up to the value: in this line, or in the next one if it stands alone there.
void MotionHeaderReader::pass_colon(std::string_view keyword) {
  const std::size_t begin = cursor_.offset();
  TextCursor colon = cursor_;
  pass_blanks_and_comments(colon);
  if (colon.peek() == ':') skip_blanks_and_comments(cursor_, report_);
  cursor_.skip_blanks_in_line();
  const std::size_t place = cursor_.offset();
  const char found = cursor_.peek();
  if (is_keyword_punctuation(found)) cursor_.move_to(place + 1);
  if (found != ':') {
    const bool stands_apart = place > begin && cursor_.offset() == place;
    const std::size_t passed = cursor_.offset() == place ? 0 : place + 1 - begin;
    result_.patches.replace(begin, passed, stands_apart || is_blank(cursor_.peek()) ? ":" : ": ");
    report_.add_each(DiagnosticCode::UnexpectedToken, place,
                     fmt::format("The colon behind {} is missing; it was added.", keyword), ":",
                     shown(TextCursor(cursor_.text(), place).peek_word()));
  }
  cursor_.skip_blanks_in_line();
  TextCursor next = cursor_;
  pass_blanks_and_comments(next);
  const std::string_view passed_text = cursor_.text().substr(cursor_.offset(), next.offset() - cursor_.offset());
  if (!passed_text.empty() && !has_line_end(passed_text)) skip_blanks_and_comments(cursor_, report_);
  if (!has_line_end(passed_text)) return;
  const std::size_t value = next.offset();
  next.take_word();
  next.skip_blanks_in_line();
  if (!next.at_end() && !is_line_end(next.peek())) return;
  skip_blanks_and_comments(cursor_, report_);
  cursor_.move_to(value);
}

/// True if the line ends where the value should stand.
bool MotionHeaderReader::value_is_missing() const { return cursor_.at_end() || is_line_end(cursor_.peek()); }

void MotionHeaderReader::read_frame_count(std::size_t begin) {
  constexpr double kLargestWhole = 9e15;
  pass_colon("Frames");
  const std::string_view word = value_is_missing() ? std::string_view() : cursor_.peek_word();
  const bool is_next_keyword = find_keyword(word) != Keyword::None;
  const NumberRead number = read_number(word);
  const bool whole = number.length > 0 && number.length == word.size() && number.value >= 0.0 &&
                     number.value <= kLargestWhole && number.value == std::floor(number.value);
  if (has_frame_count_) report_repeat(DiagnosticCode::RepeatedFrameCount, begin, "Frames:");
  has_frame_count_ = true;
  const std::size_t place = cursor_.offset();
  if (whole) {
    result_.declared_frames = static_cast<std::int64_t>(number.value);
    result_.frame_count_slot = {place, word.size(), number.value};
  } else {
    const std::size_t taken = is_next_keyword ? 0 : word.size();
    result_.patches.replace(place, taken, is_blank(cursor_.text()[place - 1]) ? std::string(1, kFrameCountMark) : std::string(" ") + kFrameCountMark);
    report_.add(DiagnosticCode::MissingFrameCount, place,
                fmt::format("'{}' is not a frame count; the rows were counted instead.", shown(word)), "a whole number",
                shown(word));
  }
  if (!is_next_keyword) cursor_.move_to(place + word.size());
  count_line_ = {begin, cursor_.offset()};
}

/// "Frame Time:" and its like; false if "Frame" is a word like others.
bool MotionHeaderReader::read_frame_line() {
  TextCursor ahead = cursor_;
  const std::size_t begin = cursor_.offset();
  ahead.move_to(begin + keyword_text(Keyword::Frame).size());
  const std::size_t gap_begin = ahead.offset();
  if (ahead.peek() == '_' || ahead.peek() == '-') ahead.move_to(gap_begin + 1);
  const bool joined = ahead.offset() > gap_begin;
  ahead.skip_blanks_in_line();
  const auto goes_on_with = [&](std::string_view word) { return equal_ignoring_case(ahead.rest().substr(0, word.size()), word); };
  const bool time = goes_on_with("Time");
  const bool rate = goes_on_with("Rate");
  const bool count = goes_on_with("Count");
  if (!time && !rate && !count && ahead.peek() != ':') return false;
  if (!time && !rate && !count && has_frame_count_ && has_frame_time_) {
    leave_line_out(begin);
    return true;
  }
  check_case("Frame");
  cursor_.move_to(ahead.offset());
  if (joined) {
    result_.patches.replace(gap_begin, 1, " ");
    report_.add_each(DiagnosticCode::UnexpectedToken, begin, "'Frame Time' is written in one word; it was read as two.",
                     "Frame Time:", shown(TextCursor(cursor_.text(), begin).peek_word()));
  }
  if (rate || count) cursor_.move_to(cursor_.offset() + (rate ? 4 : 5));
  if (time) check_case("Time");
  if (rate) {
    read_frame_rate(begin);
  } else if (count || (!time && !has_frame_count_)) {
    read_as("Frames", begin);
    read_frame_count(begin);
  } else {
    if (!time) read_as("Frame Time", begin);
    read_frame_time(begin);
  }
  return true;
}

/// The words from `begin` to the cursor stand for a keyword.
void MotionHeaderReader::read_as(const std::string& keyword, std::size_t begin) {
  result_.patches.replace(begin, cursor_.offset() - begin, keyword);
  report_.add_each(DiagnosticCode::UnexpectedToken, begin, fmt::format("This line was read as {}.", keyword), keyword + ":",
                   shown(cursor_.text().substr(begin, cursor_.offset() - begin)));
}

/// "Frame: 7" where both parts are known.
void MotionHeaderReader::leave_line_out(std::size_t begin) {
  const std::string_view line = trimmed(first_line(cursor_.rest()));
  result_.patches.remove(begin, line.size());
  report_.add_each(DiagnosticCode::UnexpectedToken, begin, fmt::format("'{}' means nothing here and was left out.", shown(line)),
                   "the first row", shown(line));
  cursor_.move_to(begin + line.size());
}

/// A frame time that is written as its inverse.
void MotionHeaderReader::read_frame_rate(std::size_t begin) {
  cursor_.skip_blanks_in_line();
  if (is_keyword_punctuation(cursor_.peek())) cursor_.move_to(cursor_.offset() + 1);
  cursor_.skip_blanks_in_line();
  const std::string_view word = cursor_.peek_word();
  const NumberRead number = read_number(word);
  const bool usable = number.length > 0 && number.length == word.size() && is_frame_time(1.0 / number.value);
  if (!value_is_missing()) cursor_.take_word();
  const std::size_t length = cursor_.offset() - begin;
  if (!usable || has_frame_time_) {
    result_.patches.remove(begin, length);
    report_.add_each(DiagnosticCode::UnexpectedToken, begin, "This frame rate is not used; it was left out.", "Frame Time:",
                     shown(cursor_.text().substr(begin, length)));
    return;
  }
  has_frame_time_ = true;
  result_.frame_time_s = 1.0 / number.value;
  std::string text = "Frame Time: ";
  append_number(result_.frame_time_s, NumberFormat{}, text);
  result_.patches.replace(begin, length, text);
  report_.add(DiagnosticCode::FrameTimeLooksLikeRate, begin,
              fmt::format("The frame rate {} stands in place of the frame time; 1/{} of a second is used.", shown(word),
                          shown(word)),
              "Frame Time:", shown(word));
  time_line_ = {begin, cursor_.offset()};
}

void MotionHeaderReader::read_frame_time(std::size_t begin) {
  pass_colon("Frame Time");
  const std::size_t place = cursor_.offset();
  const std::string_view word = value_is_missing() ? std::string_view() : cursor_.peek_word();
  if (!starts_like_number(word)) {
    result_.patches.remove(begin, place - begin);
    report_.add_each(DiagnosticCode::UnexpectedToken, begin, "No time stands behind 'Frame Time:'; it was left out.",
                     "seconds per frame", shown(word));
    return;
  }
  if (has_frame_time_) report_repeat(DiagnosticCode::RepeatedFrameTime, begin, "Frame Time:");
  has_frame_time_ = true;
  result_.frame_time_s = marey::read_frame_time(cursor_, MotionHeader().frame_time_s, result_.patches, report_);
  result_.frame_time_slot = {place, word.size(), result_.frame_time_s};
  time_line_ = {begin, cursor_.offset()};
}

void MotionHeaderReader::report_repeat(DiagnosticCode code, std::size_t place, std::string_view keyword) {
  const Line& before = code == DiagnosticCode::RepeatedFrameCount ? count_line_ : time_line_;
  result_.patches.remove(before.begin, before.end - before.begin);
  report_.add(code, place, fmt::format("'{}' stands here a second time; the last one is used.", keyword), "the first row",
              std::string(keyword));
}

void MotionHeaderReader::report_missing_motion(bool has_part, bool has_rows) {
  const std::size_t end = cursor_.offset();
  if (!has_keyword_) {
    if (has_part || has_rows) result_.patches.insert(begin_.value_or(end), "MOTION\n");
    report_.add(DiagnosticCode::MissingMotion, begin_.value_or(end),
                has_part || has_rows ? "The word MOTION is missing; it was added."
                                     : "The file has no motion; the figure is shown in its rest pose.",
                "MOTION", begin_ ? "" : "the end of the file");
  } else if (!has_part && !has_rows) {
    report_.add(DiagnosticCode::MissingMotion, end,
                "Nothing stands behind MOTION; the figure is shown in its rest pose.", "Frames:", "the end of the file");
  }
}

void MotionHeaderReader::report_missing_parts() {
  const std::size_t end = cursor_.offset();
  const bool has_rows = !cursor_.at_end();
  const bool has_part = has_frame_time_ || has_frame_count_;
  report_missing_motion(has_part, has_rows);
  if (!has_part && !has_rows) return;
  const bool opens_line = end == 0 || is_line_end(cursor_.text()[end - 1]);
  const std::string gap = opens_line ? "" : "\n";
  if (!has_frame_count_) {
    result_.patches.insert(has_frame_time_ ? time_line_.begin : end, (has_frame_time_ ? "" : gap) + "Frames: " + kFrameCountMark + "\n");
    report_.add(DiagnosticCode::MissingFrameCount, end, "'Frames:' is missing; the rows were counted instead.", "Frames:",
                "");
  }
  if (!has_frame_time_) {
    std::string text = gap + "Frame Time: ";
    append_number(result_.frame_time_s, NumberFormat{}, text);
    result_.patches.insert(end, text + "\n");
    report_.add(DiagnosticCode::MissingFrameTime, end, "'Frame Time:' is missing; 1/30 of a second is used.",
                "Frame Time:", "");
  }
}

}  // namespace

bool starts_like_number(std::string_view word) {
  if (is_not_finite_text(word)) return true;
  if (!word.empty() && (word.front() == '-' || word.front() == '+')) word.remove_prefix(1);
  return !word.empty() && (is_digit(word.front()) || word.front() == '.');
}

MotionHeader read_motion_header(TextCursor& cursor, int channel_count, Report& report) {
  return MotionHeaderReader(cursor, channel_count, report).read();
}

}  // namespace marey
