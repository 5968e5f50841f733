#include "core/base/text_cursor.h"

#include <algorithm>

namespace marey {

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return to_lower_ascii(x) == to_lower_ascii(y); });
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::size_t size = std::min(text.size(), kLongest);
  while (size < text.size() && size > 0 && (static_cast<unsigned char>(text[size]) & 0xc0U) == 0x80U) --size;
  std::string result(text.substr(0, size));
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = '?';
  }
  return text.size() > kLongest ? result + "..." : result;
}

TextPlace PlaceFinder::place_of(std::size_t offset) {
  if (offset < line_begin_) *this = PlaceFinder(text_);
  offset_ = std::max(offset_, line_begin_);
  const std::size_t stop = std::min(offset, text_.size());
  while (offset_ < stop) {
    const char c = text_[offset_++];
    const bool crlf = c == '\r' && offset_ < text_.size() && text_[offset_] == '\n';
    if (c == '\n' || (c == '\r' && !crlf)) {
      ++line_;
      line_begin_ = offset_;
    }
  }
  return {line_, static_cast<int>(offset - line_begin_) + 1};
}

void TextCursor::skip_blanks() {
  while (!at_end() && is_blank(text_[offset_])) ++offset_;
}

void TextCursor::skip_blanks_in_line() {
  while (!at_end() && is_blank(text_[offset_]) && !is_line_end(text_[offset_])) ++offset_;
}

std::string_view TextCursor::skip_line() {
  const std::size_t begin = offset_;
  while (!at_end() && !is_line_end(text_[offset_])) ++offset_;
  return text_.substr(begin, offset_ - begin);
}

std::string_view TextCursor::peek_word() const {
  std::size_t end = offset_;
  while (end < text_.size() && !is_blank(text_[end]) && text_[end] != '{' && text_[end] != '}') ++end;
  return text_.substr(offset_, end - offset_);
}

std::string_view TextCursor::take_word() {
  std::string_view word = peek_word();
  if (word.empty() && !at_end()) word = text_.substr(offset_, 1);
  offset_ += word.size();
  return word;
}

}  // namespace marey
