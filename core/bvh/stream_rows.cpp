#include "core/bvh/stream_rows.h"

#include <algorithm>

#include "core/base/byte_search.h"
#include "core/base/index.h"
#include "core/bvh/comma_habit.h"
#include "core/bvh/motion_survey.h"
#include "core/bvh/text_encoding.h"
#include "core/bvh/wide_blanks.h"

namespace marey {
namespace {

/// Rows that the first judgement of the rows looks at, and one more.
constexpr int kFirstRows = 33;

/// Behind the last line end of `text`.
std::size_t behind_last_line_end(std::string_view text) {
  const std::size_t at = find_last_line_end(text);
  return at == std::string_view::npos ? 0 : at + 1;
}

/// Where the line before the one of text[at] begins.
std::size_t begin_of_line_before(std::string_view text, std::size_t at) {
  std::size_t begin = at;
  for (int lines = 0; lines < 2 && begin > 0; ++lines) {
    const std::size_t end = text.substr(0, begin).find_last_not_of("\r\n");
    begin = end == std::string_view::npos ? 0 : behind_last_line_end(text.substr(0, end));
  }
  return begin;
}

}  // namespace

StreamRows::StreamRows(std::string head, const ReadOptions& options, std::int64_t expected_bytes)
    : head_(std::move(head)), options_(options), expected_bytes_(expected_bytes), report_(head_, false) {}

StreamRows::Start StreamRows::start() {
  DecodedText decoded;
  decode_text(head_, decoded, report_);
  if (decoded.encoding != TextEncoding::Bytes) return Start::Impossible;
  if (report_.failed() || decoded.text.size() != head_.size()) return Start::NeedsMore;
  clip_.emplace(head_, head_, decoded.begin, options_, report_);
  if (!clip_->read_header()) return Start::NeedsMore;
  input_ = clip_->rows_input();
  const std::size_t data_begin = clip_->data_begin();
  if (channel_count() == 0 || data_begin == head_.size()) return Start::NeedsMore;
  const std::string_view header = std::string_view(head_).substr(0, data_begin);
  if (!with_plain_blanks(header, decoded.begin, report_).empty()) return Start::Impossible;
  const std::size_t usual_end = find_unusual(head_, data_begin);
  const std::string_view settled = std::string_view(head_).substr(0, behind_last_line_end(std::string_view(head_).substr(0, usual_end)));
  if (settled.size() <= data_begin) return Start::NeedsMore;
  const Start judgement = look_at_rows(settled.substr(data_begin));
  if (judgement == Start::Done) start_rows(settled);
  return judgement;
}

/// Where something stands that can change what the rows mean as a whole, or the end.
std::size_t StreamRows::find_unusual(std::string_view text, std::size_t from) {
  const std::size_t comma = find_either(text, ',', ';', from);
  const std::size_t beyond = find_beyond_ascii(text, from);
  const std::size_t found = std::min(comma, beyond);
  holds_rest_ = holds_rest_ || found != std::string_view::npos;
  return std::min(found, text.size());
}

/// Whether enough lines are there, and the first ones as simple as nearly all files have them. With fewer lines the header
/// may have been cut off somewhere, and be none.
StreamRows::Start StreamRows::look_at_rows(std::string_view rows) const {
  int seen = 0;
  bool all_are_simple = true;
  while (seen < kFirstRows && !rows.empty()) {
    const std::string_view line = trimmed(first_line(rows));
    rows = behind_first_line(rows);
    if (line.empty()) continue;
    all_are_simple = all_are_simple && starts_like_number(line) && count_values(line, {}) == channel_count();
    ++seen;
  }
  if (seen < kFirstRows) return Start::NeedsMore;
  return all_are_simple ? Start::Done : Start::Impossible;
}

void StreamRows::start_rows(std::string_view settled) {
  constexpr std::int64_t kMostWaiting = std::int64_t{4} << 20;
  const auto head_bytes = static_cast<std::int64_t>(head_.size());
  input_.part = {settled, 0};
  input_.rows_bytes = std::max(expected_bytes_, head_bytes) - static_cast<std::int64_t>(input_.data_begin);
  input_.text_bytes = head_bytes + kMostWaiting;
  MotionSurvey survey =
      survey_rows(settled.substr(input_.data_begin), channel_count(), input_.declared_frames, input_.line_end);
  if (!rows_fit(input_, options_.limits, survey, report_)) return;
  rows_.emplace(input_, options_.limits, std::move(survey), report_);
  rows_->read_some();
  window_begin_ = begin_of_line_before(head_, rows_->offset());
  window_ = std::string_view(head_).substr(window_begin_);
  looked_at_ = window_.size();
  report_.move_on(std::string_view(head_).substr(window_begin_), window_begin_);
  report_.move_on(window_, window_begin_);
  rows_->move_to({std::string_view(window_).substr(0, settled.size() - window_begin_), window_begin_});
  note_excerpts();
}

void StreamRows::feed(std::string_view text, std::size_t step) {
  while (!text.empty() && !report_.failed()) {
    const std::size_t waiting = window_.size() - looked_at_;
    const std::size_t taken = holds_rest_ ? text.size() : std::min(text.size(), step - std::min(step, waiting));
    window_.append(text.substr(0, taken));
    text.remove_prefix(taken);
    report_.move_on(window_, window_begin_);
    if (!holds_rest_ && window_.size() - looked_at_ >= step) read_waiting();
  }
}

void StreamRows::read_waiting() {
  const std::size_t usual_end = find_unusual(window_, looked_at_);
  const std::string_view window = window_;
  looked_at_ = window.size();
  rows_->move_to({window.substr(0, behind_last_line_end(window.substr(0, usual_end))), window_begin_});
  rows_->read_some();
  note_excerpts();
  forget_read_rows();
}

/// One line is kept for the excerpts. Moving what is left costs no more than reading did.
void StreamRows::forget_read_rows() {
  const std::size_t kept = begin_of_line_before(window_, rows_->offset() - window_begin_);
  if (2 * kept < window_.size()) return;
  const std::size_t settled = rows_->part_end() - window_begin_ - kept;
  window_begin_ += kept;
  report_.move_on(std::string_view(window_).substr(kept), window_begin_);
  window_.erase(0, kept);
  looked_at_ = window_.size();
  report_.move_on(window_, window_begin_);
  rows_->move_to({std::string_view(window_).substr(0, settled), window_begin_});
}

BvhClip StreamRows::finish() {
  const std::string_view file_text = window_;
  std::string_view text = without_trailing_nuls(file_text, window_begin_, report_);
  const std::string plain = with_plain_blanks(text, 0, report_, window_begin_);
  if (!plain.empty()) text = plain;
  rows_->move_to({text, window_begin_});
  learn_commas(text.substr(rows_->offset() - window_begin_));
  rows_->read_all();
  if (report_.failed()) return {};
  MotionRows rows = rows_->take_result();
  const std::size_t end = rows.end;
  const ClipReader::Tail tail{{text.substr(end - window_begin_), end}, file_text.substr(end - window_begin_)};
  BvhClip clip = clip_->finish(std::move(rows), tail, static_cast<std::int64_t>(head_.size() + window_.size() + plain.size()));
  note_excerpts();
  clip.diagnostics = report_.take_diagnostics();
  return clip;
}

/// The rows that are read have no comma, so that they count the same whatever commas mean.
void StreamRows::learn_commas(std::string_view rows) {
  const std::string_view head_rows = std::string_view(head_).substr(input_.data_begin);
  const std::vector<std::string_view> lines = find_value_lines(head_rows, channel_count(), kFirstRows - 1);
  std::optional<std::int64_t> declared = input_.declared_frames;
  if (declared) *declared -= frame_count();
  const NumberLook look = find_comma_habit(rows, lines, channel_count(), declared);
  rows_->set_look(look);
  report_commas({rows, rows_->offset()}, look, report_);
}

void StreamRows::note_excerpts() {
  const std::vector<Diagnostic>& found = report_.found().list();
  if (noted_ == found.size()) return;
  const int lines_before = report_.place_of(window_begin_).line - 1;
  std::vector<TextPlace> places;
  for (; noted_ < found.size(); ++noted_) {
    const TextPlace place = found[noted_].place;
    // The window's first line is there for the second one; what is found in it stands in the header.
    if (place.line > lines_before + 1) places.push_back({place.line - lines_before, place.column});
  }
  std::vector<TextExcerpt> excerpts = make_excerpts(window_, places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    excerpts[i].first_line += lines_before;
    excerpts_.emplace_back(TextPlace{places[i].line + lines_before, places[i].column}, std::move(excerpts[i]));
  }
}

std::vector<TextExcerpt> StreamRows::find_excerpts(const Diagnostics& diagnostics) const {
  const std::vector<TextPlace> places = diagnostics.places();
  std::vector<TextExcerpt> result = make_excerpts(head_, places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto noted = std::find_if(excerpts_.begin(), excerpts_.end(), [&](const auto& entry) { return entry.first == places[i]; });
    if (noted != excerpts_.end()) result[i] = noted->second;
  }
  return result;
}

BvhClip StreamRows::clip_so_far(std::int64_t most_samples) const {
  const std::int64_t frames = std::min(rows_->store().flushed_frames(), most_samples / channel_count());
  return clip_->clip_of(rows_->store().copy_of_first(frames), static_cast<int>(frames));
}

std::int64_t StreamRows::held_bytes() const {
  const std::int64_t samples = rows_ ? rows_->store().held_bytes() : 0;
  return samples + static_cast<std::int64_t>(head_.capacity() + window_.capacity());
}

}  // namespace marey
