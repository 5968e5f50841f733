#include "core/bvh/writer.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/bits.h"
#include "core/base/fixed_number.h"
#include "core/base/index.h"
#include "core/base/text_cursor.h"
#include "core/bvh/header_writer.h"
#include "core/bvh/reader.h"
#include "core/bvh/text_encoding.h"

namespace marey {
namespace {

/// The style as it fits the motion.
MotionStyle fitted_style(const Motion& motion, const BvhStyle& style) {
  MotionStyle fitted = style.motion;
  const bool same_columns = size_of(fitted.columns) == motion.channel_count();
  if (!same_columns) fitted.columns.assign(idx(motion.channel_count()), ColumnStyle{});
  if (same_columns && fitted.frame_count == motion.frame_count()) return fitted;
  fitted.odd_tokens.clear();
  fitted.odd_text.clear();
  give_each_frame_a_line(fitted, style.header.line_end);
  return fitted;
}

class RowWriter {
 public:
  RowWriter(const Motion& motion, const MotionStyle& style, std::string& out);

  void write_all();

 private:
  /// A column as the hot loop wants it.
  struct HotColumn {
    std::uint64_t gap_word = 0;  ///< the gap's first eight bytes
    const ColumnStyle* style = nullptr;
    FixedNumberWriter fixed;
  };

  void write_row(const double* values);
  [[nodiscard]] char* write_usual(double value, const HotColumn& column, char* out);
  void write_special(double value, const ColumnStyle& column);
  void write_odd_token(double value, const ColumnStyle& column);
  void write_gap(std::string_view gap);
  [[nodiscard]] bool is_special() const {
    return index_ == 0 || (next_odd_ < style_.odd_tokens.size() && style_.odd_tokens[next_odd_].index == index_);
  }

  const Motion& motion_;
  const MotionStyle& style_;
  std::string& out_;
  std::int64_t index_ = 0;
  std::size_t next_odd_ = 0;
  std::vector<HotColumn> columns_;
  std::string row_;     ///< room for the longest row
  std::string number_;  ///< that the hot loop leaves to append_number()
};

RowWriter::RowWriter(const Motion& motion, const MotionStyle& style, std::string& out)
    : motion_(motion), style_(style), out_(out) {
  std::size_t longest_row = 0;
  for (const ColumnStyle& column : style.columns) {
    HotColumn& hot = columns_.emplace_back();
    std::copy_n(column.gap.data(), std::min(column.gap.size(), sizeof hot.gap_word), reinterpret_cast<char*>(&hot.gap_word));
    hot.style = &column;
    if (is_usual_fixed(column.format)) hot.fixed = FixedNumberWriter(column.format.decimals);
    longest_row += std::max(column.gap.size(), sizeof hot.gap_word) + kMaxNumberLength;
  }
  row_.resize(longest_row);
}

void RowWriter::write_all() {
  constexpr int kTileRows = 16;
  const int channels = motion_.channel_count();
  std::vector<double> tile(idx(kTileRows) * idx(channels));
  for (FrameIndex first = 0; first < motion_.frame_count(); first += kTileRows) {
    const int rows = std::min(kTileRows, motion_.frame_count() - first);
    for (ChannelIndex c = 0; c < channels; ++c) {
      const double* from = motion_.channel_samples(c).data() + first;
      for (int row = 0; row < rows; ++row) tile[idx(row) * idx(channels) + idx(c)] = from[row];
    }
    for (int row = 0; row < rows; ++row) {
      write_row(tile.data() + idx(row) * idx(channels));
    }
  }
}

void RowWriter::write_row(const double* values) {
  char* p = row_.data();
  for (const HotColumn& column : columns_) {
    if (is_special()) {
      out_.append(row_.data(), p);
      p = row_.data();
      write_special(*values, *column.style);
    } else {
      p = write_usual(*values, column, p);
    }
    ++values;
    ++index_;
  }
  out_.append(row_.data(), p);
}

char* RowWriter::write_usual(double value, const HotColumn& column, char* out) {
  const std::string& gap = column.style->gap;
  std::memcpy(out, &column.gap_word, sizeof column.gap_word);
  if (gap.size() > sizeof column.gap_word) std::memcpy(out, gap.data(), gap.size());
  out += gap.size();
  if (char* end = column.fixed.write(value, out)) return end;
  number_.clear();
  append_number(value, column.style->format, number_);
  return std::copy(number_.begin(), number_.end(), out);
}

void RowWriter::write_special(double value, const ColumnStyle& column) {
  if (next_odd_ < style_.odd_tokens.size() && style_.odd_tokens[next_odd_].index == index_) {
    write_odd_token(value, column);
    ++next_odd_;
  } else {
    write_gap(column.gap);
    append_number(value, column.format, out_);
  }
}

void RowWriter::write_odd_token(double value, const ColumnStyle& column) {
  const OddToken& odd = style_.odd_tokens[next_odd_];
  const std::string_view text = odd_token_text(style_, next_odd_);
  if (same_bits(odd.value, value)) {
    if (odd.index == 0) write_gap({});
    out_ += text;
    return;
  }
  // Numbers that run together stay apart only as long as the second one has its sign.
  const std::string_view gap = text.substr(0, odd.number_begin - odd.begin);
  write_gap(gap.empty() ? std::string_view(column.gap) : gap);
  append_number(value, column.format, out_);
}

/// The header ends where the first number begins; but a header without rows may end anywhere.
void RowWriter::write_gap(std::string_view gap) {
  if (index_ > 0) {
    out_ += gap;
  } else if (!out_.empty() && !is_blank(out_.back())) {
    out_ += '\n';
  }
}

/// The clip that a text is read as, if it has this motion.
std::optional<BvhClip> read_back(const Motion& motion, const std::string& text) {
  ReadOptions options;
  options.limits.max_frames = std::numeric_limits<int>::max();
  if (!kAddressesAre32Bit) options.limits.max_sample_bytes = std::numeric_limits<std::int64_t>::max();
  Result<BvhClip> again = read_bvh(text, options);
  const bool is_same = again && same_bits(again->motion.frame_time_s(), motion.frame_time_s()) &&
                       again->motion.frame_count() == motion.frame_count() &&
                       std::equal(motion.samples().begin(), motion.samples().end(), again->motion.samples().begin(),
                                  again->motion.samples().end(), same_bits<double>);
  return is_same ? std::optional(std::move(*again)) : std::nullopt;
}

bool has_break(std::string_view gap) { return gap.find_first_of("\r\n") != std::string_view::npos; }

/// Whether frames and lines are not the same: frames that go over several lines, or lines with several frames.
bool has_wrapped_rows(const MotionStyle& style) {
  const std::size_t channels = style.columns.size();
  for (std::size_t i = 0; i < channels; ++i) {
    if (has_break(style.columns[i].gap) != (i == 0)) return true;
  }
  for (std::size_t i = 0; i < style.odd_tokens.size(); ++i) {
    const OddToken& odd = style.odd_tokens[i];
    const std::string_view gap = odd_token_text(style, i).substr(0, odd.number_begin - odd.begin);
    const bool begins_frame = odd.index % static_cast<std::int64_t>(channels) == 0;
    if (odd.index > 0 && has_break(gap) != begins_frame) return true;
  }
  return false;
}

bool has_commas(const MotionStyle& style) {
  if (style.odd_text.find_first_of(",;") != std::string::npos) return true;
  return std::any_of(style.columns.begin(), style.columns.end(), [](const ColumnStyle& column) {
    return column.format.point == ',' || column.gap.find_first_of(",;") != std::string::npos;
  });
}

/// What commas mean, see core/bvh/comma_habit.h, and where a frame ends that is no line, is a matter of all rows together.
bool depends_on_all_rows(const MotionStyle& style) { return has_commas(style) || has_wrapped_rows(style); }

/// Header and rows, without what stands behind them.
std::string print(const Skeleton& skeleton, const Motion& motion, const BvhStyle& style, const MotionStyle& rows) {
  constexpr std::size_t kUsualNumber = 11;
  std::string out;
  out.reserve(style.header_text.text.size() + motion.samples().size() * kUsualNumber + style.motion.tail.size() + 4096);
  append_header(skeleton, motion, style, out);
  if (motion.channel_count() > 0) RowWriter(motion, rows, out).write_all();
  return out;
}

/// Text behind the motion can be taken for rows, or for a header above rows that are none; or it changes what is made of the
/// commas before it. It can stay if what is read is written as it was.
bool can_stay(const Motion& motion, const std::string& text) {
  const std::optional<BvhClip> again = read_back(motion, text);
  if (!again) return false;
  return print(again->skeleton, again->motion, again->style, fitted_style(again->motion, again->style)) + again->style.motion.tail == text;
}

}  // namespace

std::string write_bvh(const Skeleton& skeleton, const Motion& motion, const BvhStyle& style) {
  MotionStyle rows = fitted_style(motion, style);
  std::string out = print(skeleton, motion, style, rows);
  if (depends_on_all_rows(rows) && !read_back(motion, out + style.header.line_end)) {
    give_each_frame_a_line(rows, style.header.line_end);
    out = print(skeleton, motion, style, rows);
  }
  const std::size_t end = out.size();
  out += style.motion.tail;
  const bool only_blanks = style.motion.tail.find_first_not_of(" \t\r\n") == std::string::npos;
  if (!only_blanks && !can_stay(motion, out)) out.replace(end, std::string::npos, style.header.line_end);
  return style.encoding == TextEncoding::Bytes ? out : encoded_as_utf16(out, style.encoding);
}

}  // namespace marey
