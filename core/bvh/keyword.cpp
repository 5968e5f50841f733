#include "core/bvh/keyword.h"

#include <array>

#include "core/base/text_cursor.h"

namespace marey {
namespace {

constexpr std::array<std::string_view, 10> kTexts = {"",       "HIERARCHY", "ROOT",   "JOINT",  "End",
                                                     "OFFSET", "CHANNELS",  "MOTION", "Frames", "Frame"};

bool ends_keyword(Keyword keyword, std::string_view behind) {
  if (behind.empty()) return true;
  switch (keyword) {
    case Keyword::Frames: return behind.front() == ':';
    case Keyword::Frame: return behind.front() == ':' || equal_ignoring_case(behind.substr(0, 4), "Time");
    case Keyword::End: return equal_ignoring_case(behind.substr(0, 4), "Site");
    default: return false;
  }
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

std::string_view keyword_text(Keyword keyword) { return kTexts[static_cast<std::size_t>(keyword)]; }

}  // namespace marey
