#include "core/base/text_cursor.h"

#include <algorithm>

#include "core/base/byte_search.h"

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

TextPlace PlaceFinder::Walk::place_of(std::size_t offset) {
  const std::size_t wanted = std::max(offset, begin_) - begin_;
  if (wanted < line_begin_) *this = Walk(text_, begin_, first_line_);
  const std::size_t stop = std::min(wanted, text_.size());
  if (stop > at_) {
    const std::size_t passed = count_line_ends(text_, at_, stop);
    line_ += static_cast<int>(passed);
    for (std::size_t end = passed > 0 ? stop : 0; end > 0; --end) {
      if (count_line_ends(text_, end - 1, end) == 0) continue;
      line_begin_ = end;
      break;
    }
    at_ = stop;
  }
  return {line_, static_cast<int>(wanted - line_begin_) + 1};
}

TextPlace PlaceFinder::place_of(std::size_t offset) { return (offset < last_.begin() ? first_ : last_).place_of(offset); }

void PlaceFinder::move_on(std::string_view text, std::size_t begin) { last_ = Walk(text, begin, last_.place_of(begin).line); }

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
