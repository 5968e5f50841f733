#include "core/text/readable.h"

#include <array>
#include <string_view>

#include "core/base/index.h"
#include "core/text/character_set_guess.h"

namespace marey {

Diagnostics readable(const Diagnostics& findings, CharacterSet set) {
  Diagnostics result = findings;
  result.rewrite_texts([set](const std::string& text) { return decoded(text, set); });
  return result;
}

Error readable(Error error) {
  const std::array<std::string_view, 1> texts = {error.message};
  const CharacterSet set = guess_character_set(texts);
  error.message = decoded(error.message, set);
  error.expected = decoded(error.expected, set);
  error.found = decoded(error.found, set);
  return error;
}

TextExcerpt readable(const TextExcerpt& excerpt, CharacterSet set) {
  TextExcerpt result = excerpt;
  for (std::string& line : result.lines) line = decoded(line, set);
  if (excerpt.lines.empty()) return result;
  const std::string_view marked = excerpt.lines[idx(excerpt.marked_line)];
  result.marked_byte = size_of(decoded(marked.substr(0, idx(excerpt.marked_byte)), set));
  return result;
}

}  // namespace marey
