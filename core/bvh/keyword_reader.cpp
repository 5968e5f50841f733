#include "core/bvh/keyword_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/bvh/row_text.h"

namespace marey {
namespace {

void check_case(Keyword keyword, std::string_view word, std::size_t place, Report& report) {
  const std::string_view right = keyword_text(keyword);
  if (word.substr(0, right.size()) == right) return;
  report.add(DiagnosticCode::KeywordCase, place,
              fmt::format("'{}' was read as {}; many other programs want capitals as the format writes them.",
                          shown(word), right),
              std::string(right), shown(word));
}

/// True if HIERARCHY stands alone in a later line, before any block.
bool goes_on_with_hierarchy(std::string_view text) {
  constexpr std::size_t kLongestPreface = 8192;
  text = text.substr(0, kLongestPreface);
  text = text.substr(0, text.find('{'));
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    if (equal_ignoring_case(trimmed(line), keyword_text(Keyword::Hierarchy))) return true;
    text = behind_first_line(text);
  }
  return false;
}

}  // namespace

void take_keyword(TextCursor& cursor, Keyword keyword, HeaderPatches& patches, Report& report) {
  const std::size_t place = cursor.offset();
  const std::string_view right = keyword_text(keyword);
  const std::string_view word = cursor.peek_word();
  if (find_keyword(word) == Keyword::None) {
    cursor.take_word();
    patches.replace(place, word.size(), std::string(right));
    report.add_each(DiagnosticCode::UnexpectedToken, place,
                     fmt::format("'{}' was read as {}.", shown(word), right), std::string(right), shown(word));
    return;
  }
  check_case(keyword, word, place, report);
  const std::size_t end = place + right.size();
  cursor.move_to(end);
  if (word.size() == right.size() || keyword == Keyword::End) return;
  const bool punctuation = is_keyword_punctuation(word[right.size()]);
  if (punctuation) cursor.move_to(end + 1);
  patches.replace(end, punctuation ? 1 : 0, cursor.peek() == '\0' || is_blank(cursor.peek()) ? "" : " ");
  report.add_each(DiagnosticCode::UnexpectedToken, end,
                   punctuation ? fmt::format("The '{}' behind {} was left out.", word[right.size()], right)
                               : fmt::format("The blank behind {} is missing; it was added.", right),
                   "a blank", shown(word.substr(right.size())));
}

void take_site(TextCursor& cursor, std::size_t place, HeaderPatches& patches, Report& report) {
  constexpr std::string_view kSite = "Site";
  const std::size_t behind_end = cursor.offset();
  if (cursor.peek() == '_' || cursor.peek() == '-') {
    cursor.move_to(behind_end + 1);
    patches.replace(behind_end, 1, " ");
    report.add_each(DiagnosticCode::UnexpectedToken, place, "'End Site' is written in one word; it was read as two.",
                     "End Site", shown(TextCursor(cursor.text(), place).peek_word()));
  }
  cursor.skip_blanks();
  const std::string_view site = cursor.peek_word().substr(0, kSite.size());
  if (!equal_ignoring_case(site, kSite)) {
    cursor.move_to(behind_end);
    patches.insert(behind_end, " Site");
    report.add_each(DiagnosticCode::UnexpectedToken, place, "'End' without 'Site' was read as End Site.", "End Site",
                     shown(site));
    return;
  }
  if (site != kSite) {
    report.add(DiagnosticCode::KeywordCase, place,
                "'End Site' is not spelled as the format writes it; many other programs want capitals E and S.",
                "End Site", shown(site));
  }
  cursor.move_to(cursor.offset() + kSite.size());
}

bool is_text_before_hierarchy(Keyword keyword, std::string_view text) {
  if (keyword == Keyword::None || keyword == Keyword::Hierarchy) return false;
  const std::string_view line = trimmed(text.substr(0, text.find_first_of("\r\n")));
  const bool opens_motion = equal_ignoring_case(line, keyword_text(Keyword::Motion));
  return !opens_motion && goes_on_with_hierarchy(text);
}

}  // namespace marey
