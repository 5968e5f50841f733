#include "core/base/text_excerpt.h"

#include <algorithm>
#include <map>

#include "core/base/index.h"

namespace marey {
namespace {

/// Goes through the lines of a text; behind a last line end comes an empty line.
class LineWalk {
 public:
  explicit LineWalk(std::string_view text) : rest_(text) {}
  [[nodiscard]] bool at_end() const { return at_end_; }
  std::string_view take() {
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    at_end_ = end == rest_.size();
    const bool crlf = rest_.substr(end, 2) == "\r\n";
    rest_.remove_prefix(std::min(end + (crlf ? 2 : 1), rest_.size()));
    return line;
  }

 private:
  std::string_view rest_;
  bool at_end_ = false;
};

std::map<int, std::string_view> find_lines(std::string_view text, std::span<const TextPlace> places) {
  std::map<int, std::string_view> wanted;
  for (const TextPlace& place : places) {
    if (place.line <= 0) continue;
    for (int away = -TextExcerpt::kLinesAround; away <= TextExcerpt::kLinesAround; ++away) {
      if (place.line + away > 0) wanted.try_emplace(place.line + away);
    }
  }
  LineWalk walk(text);
  auto next = wanted.begin();
  for (int line = 1; next != wanted.end() && !walk.at_end(); ++line) {
    const std::string_view found = walk.take();
    if (line == next->first) (next++)->second = found;
  }
  wanted.erase(next, wanted.end());
  return wanted;
}

/// Where a long line is cut off at its front, so that `byte` is in the part that is shown. Never within a UTF-8 letter.
std::size_t cut_of(std::string_view line, std::size_t byte) {
  if (line.size() <= TextExcerpt::kMostBytes) return 0;
  const std::size_t half = TextExcerpt::kMostBytes / 2;
  std::size_t cut = std::min(byte > half ? byte - half : 0, line.size() - TextExcerpt::kMostBytes);
  while (cut > 0 && (static_cast<unsigned char>(line[cut]) & 0xc0U) == 0x80U) --cut;
  return cut;
}

TextExcerpt make_excerpt(const std::map<int, std::string_view>& lines, const TextPlace& place) {
  TextExcerpt excerpt;
  if (!lines.contains(place.line)) return excerpt;
  const std::size_t byte = place.column > 0 ? idx(place.column - 1) : 0;
  const std::size_t cut = cut_of(lines.at(place.line), byte);
  for (int number = std::max(place.line - TextExcerpt::kLinesAround, 1); lines.contains(number); ++number) {
    if (number > place.line + TextExcerpt::kLinesAround) break;
    if (excerpt.lines.empty()) excerpt.first_line = number;
    const std::string_view line = lines.at(number);
    excerpt.lines.emplace_back(line.substr(std::min(cut, line.size()), TextExcerpt::kMostBytes));
  }
  excerpt.marked_line = place.line - excerpt.first_line;
  excerpt.marked_byte = static_cast<int>(std::min(byte - cut, excerpt.lines[idx(excerpt.marked_line)].size()));
  return excerpt;
}

}  // namespace

std::vector<TextExcerpt> make_excerpts(std::string_view text, std::span<const TextPlace> places) {
  const std::map<int, std::string_view> lines = find_lines(text, places);
  std::vector<TextExcerpt> excerpts;
  for (const TextPlace& place : places) excerpts.push_back(make_excerpt(lines, place));
  return excerpts;
}

}  // namespace marey
