#include "wasm/app/fuzzy_match.h"

#include <cctype>
#include <string>

namespace marey::app {
namespace {

constexpr int kWordStart = 12;
constexpr int kConsecutive = 12;
constexpr int kPlain = 2;
constexpr int kJump = 3;

char lower(char character) { return static_cast<char>(std::tolower(static_cast<unsigned char>(character))); }

bool is_word_start(std::string_view text, std::size_t position) {
  return position == 0 || text[position - 1] == ' ' || text[position - 1] == '.' || text[position - 1] == '-';
}

// The first match from `from` on that starts a word, else the first match at all. A run goes on where it can.
std::size_t next_match(std::string_view text, char wanted, std::size_t from, bool after_match) {
  if (after_match && from < text.size() && lower(text[from]) == wanted) return from;
  std::size_t first = std::string_view::npos;
  for (std::size_t i = from; i < text.size(); ++i) {
    if (lower(text[i]) != wanted) continue;
    if (is_word_start(text, i)) return i;
    if (first == std::string_view::npos) first = i;
  }
  return first;
}

std::string without_blanks(std::string_view query) {
  std::string letters;
  for (const char character : query) {
    if (character != ' ') letters += lower(character);
  }
  return letters;
}

// Matches greedily from `start` on; preferring starts of words can run past a needed letter, so a plain pass follows.
std::optional<FuzzyMatch> match_from(std::string_view letters, std::string_view text, bool prefer_words) {
  FuzzyMatch match;
  std::size_t at = 0;
  for (const char wanted : letters) {
    const bool after_match = !match.positions.empty();
    std::size_t found = std::string_view::npos;
    if (prefer_words) {
      found = next_match(text, wanted, at, after_match);
    } else {
      for (std::size_t i = at; i < text.size() && found == std::string_view::npos; ++i) {
        if (lower(text[i]) == wanted) found = i;
      }
    }
    if (found == std::string_view::npos) return std::nullopt;
    const bool consecutive = after_match && found == at;
    match.score += consecutive ? kConsecutive : is_word_start(text, found) ? kWordStart : kPlain;
    if (after_match && !consecutive) match.score -= kJump;
    match.positions.push_back(static_cast<int>(found));
    at = found + 1;
  }
  match.score -= static_cast<int>(text.size()) / 8;
  return match;
}

}  // namespace

std::optional<FuzzyMatch> find_fuzzy_match(std::string_view query, std::string_view text) {
  const std::string letters = without_blanks(query);
  if (letters.empty()) return FuzzyMatch{};
  const auto by_words = match_from(letters, text, true);
  const auto plain = match_from(letters, text, false);
  if (!by_words) return plain;
  return plain && plain->score > by_words->score ? plain : by_words;
}

}  // namespace marey::app
