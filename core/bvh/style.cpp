#include "core/bvh/style.h"

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

std::string_view odd_token_text(const MotionStyle& style, std::size_t i) {
  const OddToken& odd = style.odd_tokens[i];
  const std::size_t end = i + 1 < style.odd_tokens.size() ? style.odd_tokens[i + 1].begin : style.odd_text.size();
  return std::string_view(style.odd_text).substr(odd.begin, end - odd.begin);
}

}  // namespace marey
