#include "core/bvh/writer.h"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <vector>

#include "core/base/index.h"
#include "core/base/text_cursor.h"
#include "core/bvh/header_writer.h"
#include "core/bvh/text_encoding.h"

namespace marey {
namespace {

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

class RowWriter {
 public:
  RowWriter(const Motion& motion, const BvhStyle& style, std::string& out);

  void write_all();

 private:
  void write_row(const double* row);
  void write_value(double value, int channel);
  void write_gap(int channel);

  const Motion& motion_;
  const MotionStyle& style_;
  std::string& out_;
  std::vector<ColumnStyle> columns_;
  std::int64_t index_ = 0;
  std::size_t next_odd_ = 0;
};

std::vector<ColumnStyle> columns_for(const Motion& motion, const BvhStyle& style) {
  std::vector<ColumnStyle> columns = style.motion.columns;
  if (size_of(columns) == motion.channel_count()) return columns;
  columns.assign(idx(motion.channel_count()), ColumnStyle{});
  if (!columns.empty()) columns.front().gap = style.header.line_end;
  return columns;
}

RowWriter::RowWriter(const Motion& motion, const BvhStyle& style, std::string& out)
    : motion_(motion), style_(style.motion), out_(out), columns_(columns_for(motion, style)) {}

void RowWriter::write_all() {
  constexpr int kTileRows = 16;
  const int channels = motion_.channel_count();
  if (channels == 0) return;
  std::vector<double> tile(idx(kTileRows) * idx(channels));
  for (FrameIndex first = 0; first < motion_.frame_count(); first += kTileRows) {
    const int rows = std::min(kTileRows, motion_.frame_count() - first);
    for (ChannelIndex c = 0; c < channels; ++c) {
      const double* from = motion_.channel_samples(c).data() + first;
      for (int row = 0; row < rows; ++row) tile[idx(row) * idx(channels) + idx(c)] = from[row];
    }
    for (int row = 0; row < rows; ++row) write_row(tile.data() + idx(row) * idx(channels));
  }
}

void RowWriter::write_row(const double* row) {
  for (int channel = 0; channel < motion_.channel_count(); ++channel) write_value(row[channel], channel);
}

void RowWriter::write_value(double value, int channel) {
  while (next_odd_ < style_.odd_tokens.size() && style_.odd_tokens[next_odd_].index < index_) ++next_odd_;
  if (next_odd_ < style_.odd_tokens.size() && style_.odd_tokens[next_odd_].index == index_) {
    const OddToken& odd = style_.odd_tokens[next_odd_];
    const bool last = next_odd_ + 1 == style_.odd_tokens.size();
    const std::size_t end = last ? style_.odd_text.size() : style_.odd_tokens[next_odd_ + 1].begin;
    if (same_bits(odd.value, value)) {
      out_.append(style_.odd_text, odd.begin, end - odd.begin);
      ++index_;
      return;
    }
  }
  write_gap(channel);
  append_number(value, columns_[idx(channel)].format, out_);
  ++index_;
}

/// The header ends where the first number begins; but a header without rows may end anywhere.
void RowWriter::write_gap(int channel) {
  const std::string& gap = columns_[idx(channel)].gap;
  if (index_ > 0) {
    out_ += gap;
  } else if (!out_.empty() && !is_blank(out_.back())) {
    out_ += '\n';
  }
}

}  // namespace

std::string write_bvh(const Skeleton& skeleton, const Motion& motion, const BvhStyle& style) {
  constexpr std::size_t kUsualNumber = 10;
  std::string out;
  out.reserve(style.header_text.text.size() + motion.samples().size() * kUsualNumber + style.motion.tail.size() + 4096);
  append_header(skeleton, motion, style, out);
  RowWriter(motion, style, out).write_all();
  out += style.motion.tail;
  return style.encoding == TextEncoding::Bytes ? out : encoded_as_utf16(out, style.encoding);
}

}  // namespace marey
