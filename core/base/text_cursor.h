#pragma once

#include <cstddef>
#include <string_view>

#include "core/base/diagnostic.h"

namespace marey {

/// Blank, tab, line ends, vertical tab and form feed.
[[nodiscard]] constexpr bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
[[nodiscard]] constexpr bool is_line_end(char c) { return c == '\n' || c == '\r'; }
[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] constexpr char to_lower_ascii(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
/// Compares ASCII letters in any case; other bytes must be equal.
[[nodiscard]] bool equal_ignoring_case(std::string_view a, std::string_view b);
/// `text` without the blanks at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);
/// `text` for a message: at most 40 bytes of it, no UTF-8 letter cut in two, control characters shown as '?'.
[[nodiscard]] std::string shown(std::string_view text);

/// Turns byte offsets into lines and columns. CR, LF and CRLF each end a line. Offsets that grow from call to call cost
/// one pass over the text in all.
class PlaceFinder {
 public:
  explicit PlaceFinder(std::string_view text) : first_(text), last_(text) {}
  [[nodiscard]] TextPlace place_of(std::size_t offset);

  /// Goes on in the next part of the text: text[0], which opens a line, is the byte `begin` of the whole. Of the parts before
  /// only the first one is still looked into, so it must live on; offsets in between give the first place of `text`.
  void move_on(std::string_view text, std::size_t begin);

 private:
  /// Walks through a part.
  class Walk {
   public:
    explicit Walk(std::string_view text, std::size_t begin = 0, int line = 1) : text_(text), begin_(begin), first_line_(line), line_(line) {}
    [[nodiscard]] std::size_t begin() const { return begin_; }
    TextPlace place_of(std::size_t offset);

   private:
    std::string_view text_;
    std::size_t begin_;  ///< of the text in the whole; all else counts in the text
    int first_line_;
    int line_;
    std::size_t line_begin_ = 0;
    std::size_t at_ = 0;
  };

  Walk first_;
  Walk last_;
};

/// Reads a text token by token. The text must outlive the cursor; nothing is copied.
class TextCursor {
 public:
  TextCursor(std::string_view text, std::size_t offset) : text_(text), offset_(offset) {}

  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] std::size_t offset() const { return offset_; }
  void move_to(std::size_t offset) { offset_ = offset; }
  [[nodiscard]] bool at_end() const { return offset_ >= text_.size(); }
  /// The byte at the cursor, '\0' at the end.
  [[nodiscard]] char peek() const { return at_end() ? '\0' : text_[offset_]; }
  [[nodiscard]] std::string_view rest() const { return text_.substr(offset_); }

  void skip_blanks();
  /// Blanks but no line end.
  void skip_blanks_in_line();
  /// Moves to the line end (or the end of the text) and gives the bytes passed.
  std::string_view skip_line();

  /// The bytes up to the next blank or brace, without moving; empty at a blank or brace.
  [[nodiscard]] std::string_view peek_word() const;
  /// As peek_word(), and moves behind it. At a brace: that brace.
  std::string_view take_word();

 private:
  std::string_view text_;
  std::size_t offset_;
};

}  // namespace marey
