#include "core/bvh/wide_blanks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/byte_search.h"
#include "core/base/text_cursor.h"
#include "core/bvh/keyword.h"
#include "core/bvh/row_text.h"

namespace marey {
namespace {

constexpr std::array<std::string_view, 21> kWideBlanks = {
    "\xc2\x85",     "\xc2\xa0",     "\xe1\x9a\x80", "\xe2\x80\x80", "\xe2\x80\x81", "\xe2\x80\x82", "\xe2\x80\x83",
    "\xe2\x80\x84", "\xe2\x80\x85", "\xe2\x80\x86", "\xe2\x80\x87", "\xe2\x80\x88", "\xe2\x80\x89", "\xe2\x80\x8a",
    "\xe2\x80\x8b", "\xe2\x80\xa8", "\xe2\x80\xa9", "\xe2\x80\xaf", "\xe2\x81\x9f", "\xe3\x80\x80", "\xef\xbb\xbf"};

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

/// Length of the blank beyond ASCII at text[at], 0 if there is none. A lone A0 is the no-break blank of Latin-1.
std::size_t wide_blank_length(std::string_view text, std::size_t at) {
  if (at >= text.size()) return 0;
  if (text[at] == '\xa0') {
    const bool alone = (at == 0 || is_ascii(text[at - 1])) && (at + 1 == text.size() || is_ascii(text[at + 1]));
    return alone ? 1 : 0;
  }
  const auto found = std::find_if(kWideBlanks.begin(), kWideBlanks.end(), [&](std::string_view blank) {
    return text.substr(at, blank.size()) == blank;
  });
  return found == kWideBlanks.end() ? 0 : found->size();
}

/// Moves behind blanks of any kind in the line.
std::size_t behind_blanks(std::string_view line, std::size_t at) {
  for (;;) {
    const std::size_t length = at < line.size() && is_blank(line[at]) ? 1 : wide_blank_length(line, at);
    if (length == 0) return at;
    at += length;
  }
}

/// Where the name of a joint begins in its line; npos in other lines.
std::size_t find_name(std::string_view line) {
  const std::size_t begin = behind_blanks(line, 0);
  for (const Keyword keyword : {Keyword::Root, Keyword::Joint, Keyword::End}) {
    const std::string_view text = keyword_text(keyword);
    std::size_t end = begin + text.size();
    if (!equal_ignoring_case(line.substr(begin, text.size()), text) || behind_blanks(line, end) == end) continue;
    end = behind_blanks(line, end);
    const bool has_site = keyword == Keyword::End && equal_ignoring_case(line.substr(end, 4), "Site");
    return behind_blanks(line, has_site ? end + 4 : end);
  }
  return std::string_view::npos;
}

/// A line of the text, and where blanks in it separate words.
class Line {
 public:
  explicit Line(std::string_view text) : text_(text), name_(find_name(text)), is_comment_(starts_comment(text.substr(behind_blanks(text, 0)))) {}

  [[nodiscard]] const char* end() const { return text_.data() + text_.size(); }
  /// Behind the blanks that begin at `blank`, which lies in this line.
  [[nodiscard]] const char* behind(const char* blank) const { return text_.data() + behind_blanks(text_, offset_of(blank)); }
  /// True if these blanks are not part of a name or a comment.
  [[nodiscard]] bool separates(const char* blank) const {
    if (name_ == std::string_view::npos) return !is_comment_;
    const char* next = behind(blank);
    return offset_of(blank) < name_ || next == end() || *next == '{' || *next == '}';
  }

 private:
  [[nodiscard]] std::size_t offset_of(const char* p) const { return static_cast<std::size_t>(p - text_.data()); }

  std::string_view text_;
  std::size_t name_;
  bool is_comment_;
};

Line line_around(std::string_view text, std::size_t at) {
  const std::size_t before = at == 0 ? std::string_view::npos : text.find_last_of("\r\n", at - 1);
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
  const std::size_t end = std::min(text.size(), text.find_first_of("\r\n", at));
  return Line(text.substr(begin, end - begin));
}

void report_wide_blank(std::string_view text, std::size_t at, Report& report, std::size_t text_begin) {
  report.add(DiagnosticCode::WideBlank, text_begin + at,
             "Blanks that are not ASCII stand between the words; they were read as blanks, most other programs cannot read "
             "them.",
             "a blank", shown(text.substr(at, wide_blank_length(text, at))));
}

/// Exchanges what is not ASCII in [begin, end).
void make_plain(std::string& text, std::size_t begin, std::size_t end) {
  std::replace_if(text.begin() + static_cast<std::ptrdiff_t>(begin), text.begin() + static_cast<std::ptrdiff_t>(end),
                  [](char c) { return !is_ascii(c); }, ' ');
}

}  // namespace

std::string with_plain_blanks(std::string_view text, std::size_t begin, Report& report, std::size_t text_begin) {
  std::string result;
  Line line{std::string_view()};
  for (std::size_t at = find_beyond_ascii(text, begin); at < text.size(); at = find_beyond_ascii(text, at)) {
    const std::size_t length = wide_blank_length(text, at);
    if (length == 0) {
      ++at;
      continue;
    }
    const char* blank = text.data() + at;
    if (line.end() == nullptr || blank >= line.end()) line = line_around(text, at);
    const auto end = static_cast<std::size_t>(line.behind(blank) - text.data());
    if (line.separates(blank)) {
      if (result.empty()) {
        result = text;
        report_wide_blank(text, at, report, text_begin);
      }
      make_plain(result, at, end);
    }
    at = end;
  }
  return result;
}

}  // namespace marey
