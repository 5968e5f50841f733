#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace marey::app {

struct FuzzyMatch {
  int score = 0;               ///< higher is better; comparable between texts for one query
  std::vector<int> positions;  ///< matched bytes of the text, ascending
};

/// Whether the characters of `query` occur in `text` in their order, and how well: matches at starts of words and in
/// one piece count more, a long text less. Letters match in either case (Latin only); blanks in the query are ignored.
/// An empty query matches everything with score 0.
[[nodiscard]] std::optional<FuzzyMatch> find_fuzzy_match(std::string_view query, std::string_view text);

}  // namespace marey::app
