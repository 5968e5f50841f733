#include "core/bvh/joint_name.h"

#include "core/bvh/keyword.h"
#include "core/text/character_set.h"
#include "core/text/utf8.h"

namespace marey {
namespace {

bool is_brace(char c) { return c == '{' || c == '}'; }

/// Whether in `set` the byte at `at` is the second one of a letter of `name`.
bool is_second_byte_in(CharacterSet set, std::string_view name, std::size_t at) {
  for (std::size_t begin = 0; begin < at;) {
    const std::size_t end = begin + letter_at(name, begin, set).length;
    if (end > at) return true;
    begin = end;
  }
  return false;
}

bool is_second_byte(std::string_view name, std::size_t at) {
  if (is_utf8(name.substr(0, at))) return false;
  return is_second_byte_in(CharacterSet::ShiftJis, name, at) || is_second_byte_in(CharacterSet::Gbk, name, at);
}

/// Whether what follows a brace can only stand in a block.
bool goes_on_in_a_block(std::string_view behind) {
  TextCursor cursor(behind, 0);
  cursor.skip_blanks();
  return cursor.offset() > 0 && find_keyword(cursor.peek_word()) != Keyword::None;
}

}  // namespace

std::string_view take_joint_name(TextCursor& cursor) {
  cursor.skip_blanks_in_line();
  const std::string_view rest = cursor.rest();
  std::size_t size = 0;
  while (size < rest.size() && !is_line_end(rest[size])) {
    const bool ends = is_brace(rest[size]) && (!is_second_byte(rest.substr(0, size + 1), size) ||
                                               goes_on_in_a_block(rest.substr(size + 1)));
    if (ends) break;
    ++size;
  }
  cursor.move_to(cursor.offset() + size);
  const std::string_view name = rest.substr(0, size);
  const bool at_brace = size < rest.size() && is_brace(rest[size]);
  return at_brace || trimmed(name).empty() ? trimmed(name) : name;
}

std::string printable_joint_name(std::string_view name) {
  std::size_t front = 0;
  while (front < name.size() && is_blank(name[front])) ++front;
  std::string result(name.substr(front));
  for (std::size_t at = 0; at < result.size(); ++at) {
    char& c = result[at];
    if (is_line_end(c) || c == '\0' || (is_brace(c) && !is_second_byte(result, at))) c = '_';
  }
  return result;
}

}  // namespace marey
