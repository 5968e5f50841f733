#include "core/bvh/row_text.h"

#include "core/base/byte_search.h"

#include <algorithm>

namespace marey {

std::size_t value_length(std::string_view text, const NumberLook& look) {
  std::size_t at = 1;
  while (at < text.size() && !is_separator(text[at], look) && !runs_together(text, at)) ++at;
  return std::min(at, text.size());
}

int count_values(std::string_view line, const NumberLook& look) {
  int count = 0;
  for (;;) {
    line.remove_prefix(gap_length(line, look));
    if (line.empty()) return count;
    const std::size_t comment = comment_length(line);
    line.remove_prefix(comment > 0 ? comment : value_length(line, look));
    count += comment > 0 ? 0 : 1;
  }
}

std::string_view first_line(std::string_view text) { return text.substr(0, find_either(text, '\r', '\n')); }

std::string_view behind_first_line(std::string_view text) {
  text.remove_prefix(first_line(text).size());
  const bool is_pair = text.substr(0, 2) == "\r\n";
  return text.substr(std::min<std::size_t>(is_pair ? 2 : 1, text.size()));
}

std::size_t gap_length(std::string_view text, const NumberLook& look) {
  std::size_t at = 0;
  while (at < text.size() && is_separator(text[at], look)) ++at;
  return at;
}

bool has_line_end(std::string_view gap) { return gap.find_first_of("\r\n") != std::string_view::npos; }

std::size_t comment_length(std::string_view text) {
  constexpr std::size_t kLongestBlock = 1024;
  if (!starts_comment(text)) return 0;
  const bool is_block = text.substr(0, 2) == "/*";
  const std::size_t block_end = is_block ? text.substr(0, kLongestBlock).find("*/", 2) : std::string_view::npos;
  return block_end != std::string_view::npos ? block_end + 2 : first_line(text).size();
}

bool starts_comment(std::string_view text) {
  const std::string_view start = text.substr(0, 2);
  return text.substr(0, 1) == "#" || text.substr(0, 1) == ";" || start == "//" || start == "/*";
}

}  // namespace marey
