#include "core/bvh/row_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/byte_search.h"
#include "core/base/counted.h"
#include "core/base/fixed_number.h"
#include "core/base/plain_number.h"
#include "core/bvh/comma_habit.h"
#include "core/bvh/motion_header.h"

namespace marey {
namespace {

/// Memory for odd tokens: small beside the samples, but enough for every token of a small file.
std::size_t odd_token_bytes(std::int64_t frames, int channel_count) {
  const auto samples = static_cast<std::size_t>(frames) * idx(channel_count);
  return std::size_t{512} * 1024 + samples * sizeof(double) / 12;
}

std::string_view rows_of(const RowsInput& input) { return input.part.text.substr(input.data_begin - input.part.begin); }

/// Frames to make room for: as declared where that is believable, else what rows like the first ones make.
std::int64_t expected_frames(const RowsInput& input, const MotionSurvey& survey, std::int64_t most_frames) {
  const auto shortest_row = static_cast<std::int64_t>(2) * input.channel_count;
  const std::int64_t held = input.rows_bytes / shortest_row + 1;
  const double likely = survey.bytes_per_row > 0.0 ? static_cast<double>(input.rows_bytes) / survey.bytes_per_row : 0.0;
  const std::int64_t declared = input.declared_frames.value_or(held);
  const auto declared_as_real = static_cast<double>(declared);
  const bool believable =
      input.declared_frames && declared_as_real <= 2.0 * likely + 16.0 && declared_as_real >= 0.5 * likely - 16.0;
  if (believable) return std::min({declared, held, most_frames});
  if (likely > 0.0) return std::min({static_cast<std::int64_t>(1.02 * likely) + 1, held, most_frames});
  const std::string_view rows = rows_of(input);
  const std::int64_t lines = std::count(rows.begin(), rows.end(), '\n') + 1;
  return std::min({lines, held, most_frames});
}

std::int64_t sample_budget(const RowsInput& input, const ReadLimits& limits) {
  return std::max<std::int64_t>(0, std::min(limits.max_sample_bytes, limits.max_bytes - input.text_bytes));
}

/// Frames that memory has room for.
std::int64_t sample_frames(const RowsInput& input, const ReadLimits& limits) {
  return sample_budget(input, limits) / (static_cast<std::int64_t>(sizeof(double)) * input.channel_count);
}

void fail_for_memory(const RowsInput& input, const ReadLimits& limits, std::size_t place, Report& report) {
  report.fail(DiagnosticCode::LimitMemory, place,
              fmt::format("The file has too many frames of {} for the {} that samples may take. Split the file.",
                          counted(input.channel_count, "channel"), counted(sample_budget(input, limits), "byte")));
}

/// True if as many frames are both declared and there as memory has no room for: told before any memory is taken.
bool is_surely_too_long(const RowsInput& input, const MotionSurvey& survey, std::int64_t most_frames) {
  if (input.declared_frames.value_or(0) <= most_frames) return false;
  const double likely_frames = static_cast<double>(input.rows_bytes) / std::max(survey.bytes_per_row, 1.0);
  if (3.0 * likely_frames < 2.0 * static_cast<double>(most_frames)) return false;
  const bool has_all_rows = static_cast<std::int64_t>(rows_of(input).size()) >= input.rows_bytes;
  if (!has_all_rows) return 2.0 * likely_frames > 3.0 * static_cast<double>(most_frames);
  return take_census(rows_of(input), survey.look).values / input.channel_count > most_frames;
}

}  // namespace

RowReader::RowReader(const RowsInput& input, const ReadLimits& limits, MotionSurvey survey, Report& report)
    : input_(input),
      limits_(limits),
      survey_(std::move(survey)),
      report_(report),
      channel_count_(input.channel_count),
      at_(rows_of(input).data()),
      end_(input.part.text.data() + input.part.text.size()),
      sample_frames_(sample_frames(input, limits)),
      most_frames_(std::min<std::int64_t>(limits.max_frames, sample_frames_)),
      store_(channel_count_, expected_frames(input, survey_, most_frames_), sample_frames_),
      odd_tokens_(odd_token_bytes(expected_frames(input, survey_, most_frames_), channel_count_)) {
  prepare_columns();
}

void RowReader::prepare_columns() {
  for (const ColumnStyle& column : survey_.columns) {
    HotColumn hot;
    hot.gap_length = size_of(column.gap);
    const std::size_t bytes = std::min(column.gap.size(), sizeof hot.gap_word);
    std::copy_n(column.gap.data(), bytes, reinterpret_cast<char*>(&hot.gap_word));
    // A gap that does not fit into a word takes the longer way: no word is like it under an empty mask.
    const bool fits = !column.gap.empty() && column.gap.size() <= sizeof hot.gap_word;
    hot.gap_mask = fits ? ~std::uint64_t{0} >> (64 - 8 * bytes) : 0;
    if (!fits) hot.gap_word = 1;
    hot.spelling = PlainSpelling(column.format);
    hot_columns_.push_back(hot);
  }
  find_runs();
}

/// Neighbours with the same gap and the same decimals.
void RowReader::find_runs() {
  constexpr int kLongestRun = 32;
  for (int first = 0, last = 0; first < channel_count_; first = last) {
    const ColumnStyle& style = survey_.columns[idx(first)];
    const auto is_like_first = [&](const ColumnStyle& column) {
      return column.gap == style.gap && is_usual_fixed(column.format) && column.format.decimals == style.format.decimals;
    };
    const bool is_run = !style.gap.empty() && style.gap.size() <= FixedNumbers::kLongestGap && is_usual_fixed(style.format);
    const int longest = is_run ? std::min(first + kLongestRun, channel_count_) : first + 1;
    for (last = first + 1; last < longest && is_like_first(survey_.columns[idx(last)]);) ++last;
    hot_columns_[idx(first)].run_length = last - first;
    if (is_run) hot_columns_[idx(first)].run.emplace(style.gap, style.format.decimals);
  }
}

void RowReader::read_all() {
  while (!rows_ended_ && !report_.failed()) {
    if (!(is_predictable() && read_predicted_row()) && !read_irregular_row()) break;
    check_limits();
  }
  store_.flush();
  if (store_.is_full()) fail_beyond_limit();
  if (!report_.failed()) report_frame_count();
}

void RowReader::read_some() {
  while (!rows_ended_ && !report_.failed() && !all_declared_read()) {
    if (!(is_predictable() && read_predicted_row())) {
      if (frames() > 0 && !is_settled()) return;
      rows_ended_ = !read_irregular_row();
    }
    check_limits();
  }
}

/// Whether the part has as many lines of numbers behind the next row as any repair looks at.
bool RowReader::is_settled() {
  constexpr int kMostLinesLookedAt = 32;
  constexpr int kShortestLine = 2;
  const int lines = channel_count_ + kMostLinesLookedAt;
  if (end_ - at_ < static_cast<std::ptrdiff_t>(lines) * kShortestLine) return false;
  if (!settled_end_) settled_end_ = begin_of_last_lines(lines);
  return offset() < *settled_end_;
}

/// Where the last so many lines of numbers begin.
std::size_t RowReader::begin_of_last_lines(int lines) const {
  std::string_view left = input_.part.text;
  while (lines > 0 && !left.empty()) {
    const std::size_t end = find_last_line_end(left.substr(0, left.size() - 1));
    const std::size_t begin = end == std::string_view::npos ? 0 : end + 1;
    const std::string_view line = trimmed(left.substr(begin));
    if (starts_like_number(line.substr(0, 2))) --lines;
    left = left.substr(0, begin);
  }
  return input_.part.begin + left.size();
}

void RowReader::move_to(TextPart part) {
  const std::size_t at = offset();
  input_.part = part;
  at_ = part.text.data() + (at - part.begin);
  end_ = part.text.data() + part.text.size();
  settled_end_.reset();
  odd_tokens_.allow(odd_token_bytes(frames(), channel_count_));
}

bool RowReader::read_predicted_row() {
  const OddTokens::Mark mark = odd_tokens_.mark();
  double* row = store_.next_row();
  const char* p = at_;
  for (int channel = 0; channel < channel_count_;) {
    const HotColumn& column = hot_columns_[idx(channel)];
    const int run_end = channel + column.run_length;
    if (const char* end = column.run ? read_run(p, column, row + channel) : nullptr) {
      channel = run_end;
      p = end;
      continue;
    }
    for (; channel < run_end; ++channel) {
      p = read_predicted_value(p, channel, row[channel]);
      if (p == nullptr) {
        odd_tokens_.go_back(mark);
        return false;
      }
    }
  }
  at_ = p;
  store_.commit_row();
  return true;
}

/// Null where one of the run's columns is not as predicted, or a try is not worthwhile.
const char* RowReader::read_run(const char* p, const HotColumn& column, double* values) {
  constexpr int kGivingUp = 64;
  constexpr int kTriedAgain = 4096;
  if (failed_runs_ >= kGivingUp && ++failed_runs_ < kTriedAgain) return nullptr;
  const std::ptrdiff_t reach = column.run_length * FixedNumbers::kReachPerNumber + FixedNumbers::kReachBehind;
  if (end_ - p < reach || p - input_.part.text.data() < FixedNumbers::kReachBefore) return nullptr;
  const char* const end = column.run->read(p, column.run_length, values);
  failed_runs_ = end != nullptr ? 0 : std::min(failed_runs_ + 1, kGivingUp);
  return end;
}

const char* RowReader::read_predicted_value(const char* p, int channel, double& value) {
  const HotColumn& column = hot_columns_[idx(channel)];
  const bool in_reach = end_ - p > kPlainNumberReach + column.gap_length;
  if (in_reach && (detail::load_eight(p) & column.gap_mask) == column.gap_word) {
    const char* begin = p + column.gap_length;
    const PlainNumber number = scan_plain_number(begin, survey_.look.point);
    if (number.end != nullptr && column.spelling.matches(begin, number)) {
      value = number.value();
      return number.end;
    }
  }
  return read_unpredicted_value(p, channel, value);
}

/// A number that is not spelled as its column predicts, but sound and in its place; null if it is anything else.
const char* RowReader::read_unpredicted_value(const char* p, int channel, double& value) {
  const std::string_view gap = rest(p).substr(0, gap_length(rest(p), survey_.look));
  const bool new_line_wanted = channel == 0;
  if (gap.empty()) return nullptr;
  if (survey_.layout != RowLayout::Stream && has_line_end(gap) != new_line_wanted) return nullptr;
  const char* begin = p + gap.size();
  const NumberRead number = read_number(rest(begin), survey_.look.point);
  const char* end = begin + number.length;
  if (number.length == 0 || number.out_of_range) return nullptr;
  if (end != end_ && !is_separator(*end, survey_.look)) return nullptr;
  value = number.value;
  const std::string_view text(begin, number.length);
  if (!text_is_predicted(channel, value, gap, text)) {
    odd_tokens_.add(frames() * channel_count_ + channel, value, gap, text);
  }
  return end;
}

bool RowReader::text_is_predicted(int channel, double value, std::string_view gap, std::string_view number) const {
  const ColumnStyle& column = survey_.columns[idx(channel)];
  return gap == column.gap && is_spelled_as(number, value, column.format);
}

void RowReader::check_limits() {
  if (frames() > most_frames_ || store_.is_full()) fail_beyond_limit();
}

void RowReader::fail_beyond_limit() {
  if (most_frames_ == limits_.max_frames && !store_.is_full()) {
    report_.fail(DiagnosticCode::LimitFrames, offset_of(at_),
                 fmt::format("The file has more than {} frames, which is the limit.", limits_.max_frames));
  } else {
    fail_for_memory(input_, limits_, offset_of(at_), report_);
  }
}

void RowReader::report_frame_count() {
  if (!input_.declared_frames || *input_.declared_frames == frames()) return;
  const std::int64_t surplus = frames() - *input_.declared_frames;
  const std::string assumption =
      surplus > 0 ? fmt::format("; the last {} taken for {}.", surplus == 1 ? "one was" : fmt::format("{} were", surplus),
                                surplus == 1 ? "a frame like the others" : "frames like the others")
                  : std::string("; the rows are what counts.");
  report_.add(DiagnosticCode::FrameCountMismatch, input_.declared_place,
              fmt::format("'Frames:' says {}, the file holds {}{}", *input_.declared_frames, counted(frames(), "row"),
                          assumption),
              counted(*input_.declared_frames, "frame"), counted(frames(), "frame"));
}

MotionRows RowReader::take_result() {
  MotionRows result;
  result.frame_count = static_cast<int>(frames());
  result.end = offset_of(at_);
  result.samples = store_.take_samples();
  result.style.columns = std::move(survey_.columns);
  result.style.frame_count = result.frame_count;
  // What commas mean was found without a count; written with one, the same rows might be understood in another way.
  const bool found_commas = survey_.look.point == ',' || survey_.look.commas_separate;
  result.lines_are_new = repaired_ || odd_tokens_.overflowed() || (found_commas && !input_.declared_frames);
  odd_tokens_.move_into(result.style);
  if (result.lines_are_new) give_each_frame_a_line(result.style, std::string(input_.line_end));
  return result;
}

void report_commas(TextPart rows, const NumberLook& look, Report& report) {
  if (look.point != ',' && !look.commas_separate) return;
  const std::size_t comma = rows.text.find_first_of(",;");
  if (look.point == ',') {
    std::size_t begin = comma;
    while (begin > 0 && !is_blank(rows.text[begin - 1])) --begin;
    report.add(DiagnosticCode::DecimalComma, rows.begin + begin,
               "The numbers have decimal commas throughout, which were read as points; most other programs cannot read them.",
               "decimal points", shown(TextCursor(rows.text, begin).peek_word()));
  } else {
    report.add(DiagnosticCode::CommaBetweenNumbers, rows.begin + comma,
               "Commas stand between the numbers; they were read as blanks, most other programs cannot read them.",
               "blanks", std::string(1, rows.text[comma]));
  }
}

namespace {

/// Without channels there are no values to count, so the declared count is all there is.
MotionRows rows_without_channels(const RowsInput& input, const ReadLimits& limits, Report& report) {
  MotionRows rows;
  rows.end = input.data_begin;
  const std::int64_t frames = input.declared_frames.value_or(0);
  if (frames > limits.max_frames) {
    report.fail(DiagnosticCode::LimitFrames, input.declared_place,
                fmt::format("The file declares {} frames; the limit is {}.", frames, limits.max_frames));
    return rows;
  }
  rows.frame_count = static_cast<int>(frames);
  return rows;
}

}  // namespace

bool rows_fit(const RowsInput& input, const ReadLimits& limits, const MotionSurvey& survey, Report& report) {
  const std::int64_t room = sample_frames(input, limits);
  if (room >= limits.max_frames || !is_surely_too_long(input, survey, room)) return true;
  fail_for_memory(input, limits, input.data_begin, report);
  return false;
}

MotionRows read_motion_rows(const RowsInput& input, const ReadLimits& limits, Report& report) {
  if (input.channel_count == 0) return rows_without_channels(input, limits, report);
  const TextPart rows{rows_of(input), input.data_begin};
  MotionSurvey survey = survey_rows(rows.text, input.channel_count, input.declared_frames, input.line_end);
  report_commas(rows, survey.look, report);
  if (!rows_fit(input, limits, survey, report)) return {};
  RowReader reader(input, limits, std::move(survey), report);
  reader.read_all();
  return report.failed() ? MotionRows{} : reader.take_result();
}

}  // namespace marey
