#include "core/bvh/keyword.h"

#include <array>
#include <utility>

#include "core/base/text_cursor.h"

namespace marey {
namespace {

constexpr std::array<std::string_view, 10> kTexts = {"",       "HIERARCHY", "ROOT",   "JOINT",  "End",
                                                     "OFFSET", "CHANNELS",  "MOTION", "Frames", "Frame"};

/// "Site" or "Time" behind a word that should stand apart from it: "EndSite", "Frame_Time".
bool goes_on_with(std::string_view behind, std::string_view second) {
  if (behind.front() == '_' || behind.front() == '-') behind.remove_prefix(1);
  return equal_ignoring_case(behind.substr(0, second.size()), second);
}

bool ends_keyword(Keyword keyword, std::string_view behind) {
  if (behind.empty()) return true;
  const char next = behind.front();
  const bool starts_number = is_digit(next) || next == '-' || next == '+' || next == '.';
  switch (keyword) {
    case Keyword::Frames: return next == ':' || next == '=';
    case Keyword::Frame: return next == ':' || goes_on_with(behind, "Time") || goes_on_with(behind, "Rate");
    case Keyword::End: return goes_on_with(behind, "Site");
    case Keyword::Offset: return is_keyword_punctuation(next) || starts_number;
    case Keyword::Channels: return is_keyword_punctuation(next) || is_digit(next);
    default: return is_keyword_punctuation(next);
  }
}

/// True if one letter more, one less, another one, or two exchanged neighbours make `word` into `right`.
bool is_one_letter_off(std::string_view word, std::string_view right) {
  if (word.size() > right.size()) std::swap(word, right);
  if (right.size() - word.size() > 1) return false;
  const auto same = [](char a, char b) { return to_lower_ascii(a) == to_lower_ascii(b); };
  std::size_t at = 0;
  while (at < word.size() && same(word[at], right[at])) ++at;
  const auto rest_is_equal = [&](std::size_t of_word, std::size_t of_right) {
    return of_word <= word.size() && of_right <= right.size() && equal_ignoring_case(word.substr(of_word), right.substr(of_right));
  };
  if (word.size() < right.size()) return rest_is_equal(at, at + 1);
  if (rest_is_equal(at + 1, at + 1)) return true;
  return at + 1 < word.size() && same(word[at], right[at + 1]) && same(word[at + 1], right[at]) && rest_is_equal(at + 2, at + 2);
}

}  // namespace

Keyword find_keyword(std::string_view word) {
  for (std::size_t i = 1; i < kTexts.size(); ++i) {
    const std::string_view text = kTexts[i];
    if (!equal_ignoring_case(word.substr(0, text.size()), text)) continue;
    if (ends_keyword(static_cast<Keyword>(i), word.substr(text.size()))) return static_cast<Keyword>(i);
  }
  return Keyword::None;
}

Keyword find_misspelled_keyword(std::string_view word) {
  while (!word.empty() && is_keyword_punctuation(word.back())) word.remove_suffix(1);
  for (const Keyword keyword : {Keyword::Hierarchy, Keyword::Root, Keyword::Joint, Keyword::Offset, Keyword::Channels, Keyword::Motion}) {
    if (is_one_letter_off(word, keyword_text(keyword))) return keyword;
  }
  return Keyword::None;
}

std::string_view keyword_text(Keyword keyword) { return kTexts[static_cast<std::size_t>(keyword)]; }

}  // namespace marey
