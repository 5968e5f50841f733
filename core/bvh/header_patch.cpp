#include "core/bvh/header_patch.h"

#include <algorithm>

#include "core/base/stable_order.h"
#include "core/base/text_cursor.h"

namespace marey {
namespace {

bool is_blank_in_line(char c) { return is_blank(c) && !is_line_end(c); }

std::size_t behind_blanks(std::string_view text, std::size_t at) {
  while (at < text.size() && is_blank_in_line(text[at])) ++at;
  return at;
}

std::size_t before_blanks(std::string_view text, std::size_t at) {
  while (at > 0 && is_blank_in_line(text[at - 1])) --at;
  return at;
}

std::size_t behind_line_end(std::string_view text, std::size_t at) {
  if (at >= text.size()) return at;
  return at + (text.substr(at, 2) == "\r\n" ? 2 : 1);
}

/// Takes blanks along that would be left over: those before the words, those behind words that open a line, and the line
/// end of a line that would be empty.
void widen_removal(std::string_view text, std::size_t& begin, std::size_t& length) {
  const std::size_t end = begin + length;
  const std::size_t wide_begin = before_blanks(text, begin);
  const std::size_t wide_end = behind_blanks(text, end);
  const bool opens_line = wide_begin == 0 || is_line_end(text[wide_begin - 1]);
  if (opens_line && (wide_end == text.size() || is_line_end(text[wide_end]))) {
    begin = wide_begin;
    length = behind_line_end(text, wide_end) - begin;
  } else if (opens_line) {
    length = wide_end - begin;
  } else if (end == text.size() || is_blank(text[end])) {
    begin = wide_begin;
    length = end - begin;
  }
}

void append_replacement(std::string_view replacement, std::string_view line_end, std::int64_t frame_count, std::string& out) {
  for (const char c : replacement) {
    if (c == '\n') {
      out += line_end;
    } else if (c == kFrameCountMark) {
      out += std::to_string(frame_count);
    } else {
      out += c;
    }
  }
}

}  // namespace

void HeaderPatches::append(const HeaderPatches& others) {
  patches_.insert(patches_.end(), others.patches_.begin(), others.patches_.end());
  is_local_ = is_local_ && others.is_local_;
}

/// By rising place; words taken out one after the other are one patch, which takes their blanks and empty lines along.
std::vector<HeaderPatches::Patch> HeaderPatches::merged(std::string_view text) const {
  std::vector<Patch> sorted = patches_;
  sort_stably(sorted, [](const Patch& a, const Patch& b) {
    return a.begin != b.begin ? a.begin < b.begin : a.length > b.length;
  });
  std::vector<Patch> result;
  for (const Patch& patch : sorted) {
    const std::size_t end = result.empty() ? 0 : result.back().begin + result.back().length;
    if (!result.empty() && patch.begin < end) continue;
    const bool joins = !result.empty() && result.back().text.empty() && patch.text.empty() &&
                       before_blanks(text, patch.begin) <= end;
    if (joins) {
      result.back().length = patch.begin + patch.length - result.back().begin;
    } else {
      result.push_back(patch);
    }
  }
  for (Patch& patch : result) {
    if (patch.text.empty()) widen_removal(text, patch.begin, patch.length);
  }
  return result;
}

std::string HeaderPatches::applied_to(std::string_view text, std::string_view line_end, std::int64_t frame_count) const {
  std::string out;
  std::size_t done = 0;
  for (const Patch& patch : merged(text)) {
    if (patch.begin < done || patch.begin + patch.length > text.size()) continue;
    out += text.substr(done, patch.begin - done);
    append_replacement(patch.text, line_end, frame_count, out);
    done = patch.begin + patch.length;
  }
  out += text.substr(done);
  return out;
}

std::string indent_at(std::string_view indent, std::size_t depth) {
  constexpr std::size_t kWidest = 256;
  std::string result;
  for (std::size_t i = 0; i < depth && result.size() + indent.size() <= kWidest && !indent.empty(); ++i) result += indent;
  return result;
}

std::string indent_before(std::string_view text, std::size_t place) {
  const std::size_t begin = before_blanks(text, place);
  const bool opens_line = begin == 0 || is_line_end(text[begin - 1]);
  return opens_line ? std::string(text.substr(begin, place - begin)) : std::string(" ");
}

}  // namespace marey
