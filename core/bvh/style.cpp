#include "core/bvh/style.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/base/index.h"
#include "core/bvh/row_text.h"

namespace marey {

namespace {

bool fits_line_per_frame(std::string_view gap, bool first_column) { return has_line_end(gap) == first_column; }

bool has_comma(std::string_view text) { return text.find_first_of(",;") != std::string_view::npos; }

}  // namespace

void give_each_frame_a_line(MotionStyle& style, const std::string& line_end) {
  const int channel_count = size_of(style.columns);
  for (int c = 0; c < channel_count; ++c) {
    ColumnStyle& column = style.columns[idx(c)];
    column.format.point = '.';
    if (fits_line_per_frame(column.gap, c == 0) && !has_comma(column.gap)) continue;
    column.gap = c == 0 ? line_end : std::string(1, ' ');
  }
  std::vector<OddToken> kept;
  std::string kept_text;
  for (std::size_t i = 0; i < style.odd_tokens.size(); ++i) {
    OddToken odd = style.odd_tokens[i];
    const std::string_view text = odd_token_text(style, i);
    const std::string_view gap = text.substr(0, odd.number_begin - odd.begin);
    const bool fits = odd.index == 0 || fits_line_per_frame(gap, odd.index % channel_count == 0);
    if (!fits || has_comma(text)) continue;
    odd.begin = static_cast<std::uint32_t>(kept_text.size());
    odd.number_begin = odd.begin + static_cast<std::uint32_t>(gap.size());
    kept_text += text;
    kept.push_back(odd);
  }
  style.odd_tokens = std::move(kept);
  style.odd_text = std::move(kept_text);
}

MotionStyle with_frames(const MotionStyle& style, std::span<const FrameIndex> file_frames) {
  MotionStyle result;
  result.frame_count = size_of(file_frames);
  result.columns = style.columns;
  result.tail = style.tail;
  const std::int64_t channel_count = size_of(style.columns);
  const auto by_index = [](const OddToken& odd, std::int64_t index) { return odd.index < index; };
  for (FrameIndex frame = 0; frame < size_of(file_frames); ++frame) {
    const std::int64_t file_row = file_frames[idx(frame)] * channel_count;
    auto odd = std::lower_bound(style.odd_tokens.begin(), style.odd_tokens.end(), file_row, by_index);
    for (; odd != style.odd_tokens.end() && odd->index < file_row + channel_count; ++odd) {
      const std::string_view text = odd_token_text(style, static_cast<std::size_t>(odd - style.odd_tokens.begin()));
      const std::string_view number = text.substr(odd->number_begin - odd->begin);
      const std::int64_t index = odd->index - file_row + frame * channel_count;
      // The first sample of all follows the header without a gap, every other has one.
      const std::string_view usual_gap = odd->index == 0 ? std::string_view(style.columns[0].gap)
                                                         : text.substr(0, odd->number_begin - odd->begin);
      const std::string_view gap = index == 0 ? std::string_view() : usual_gap;
      const auto begin = static_cast<std::uint32_t>(result.odd_text.size());
      result.odd_tokens.push_back({index, odd->value, begin, begin + static_cast<std::uint32_t>(gap.size())});
      result.odd_text.append(gap).append(number);
    }
  }
  return result;
}

std::string_view odd_token_text(const MotionStyle& style, std::size_t i) {
  const OddToken& odd = style.odd_tokens[i];
  const std::size_t end = i + 1 < style.odd_tokens.size() ? style.odd_tokens[i + 1].begin : style.odd_text.size();
  return std::string_view(style.odd_text).substr(odd.begin, end - odd.begin);
}

}  // namespace marey
