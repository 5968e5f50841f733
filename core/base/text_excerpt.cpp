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

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

/// A place not behind `cut` between two letters: of UTF-8 always, of other sets where a byte that is a letter by itself
/// is not far.
std::size_t letter_start(std::string_view line, std::size_t cut) {
  constexpr std::size_t kFarthest = 20;
  constexpr char kLeastSecondByte = 0x40;
  if (cut == 0 || (is_ascii(line[cut]) && is_ascii(line[cut - 1]))) return cut;
  for (std::size_t at = cut; at > 0 && cut - at < kFarthest; --at) {
    if (is_ascii(line[at - 1]) && line[at - 1] < kLeastSecondByte) return at;
  }
  while (cut > 0 && (static_cast<unsigned char>(line[cut]) & 0xc0U) == 0x80U) --cut;
  return cut;
}

/// Where a long line is cut off at its front, so that `byte` is in the part that is shown.
std::size_t cut_of(std::string_view line, std::size_t byte) {
  if (line.size() <= TextExcerpt::kMostBytes) return 0;
  const std::size_t half = TextExcerpt::kMostBytes / 2;
  return letter_start(line, std::min(byte > half ? byte - half : 0, line.size() - TextExcerpt::kMostBytes));
}

/// What is shown of a line that is cut off at `cut`, or is shorter.
std::string_view part_of(std::string_view line, std::size_t cut) {
  const std::size_t begin = std::min(cut, line.size());
  const std::size_t end = begin + TextExcerpt::kMostBytes;
  return line.substr(begin, end < line.size() ? letter_start(line, end) - begin : std::string_view::npos);
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
    excerpt.lines.emplace_back(part_of(line, cut));
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
