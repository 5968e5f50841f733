#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"

namespace marey {

/// A place of a text with the lines around it, to be shown to people.
struct TextExcerpt {
  static constexpr int kLinesAround = 1;
  static constexpr std::size_t kMostBytes = 96;  ///< of a line; of a longer one the part around the place

  int first_line = 0;              ///< number of lines[0], from 1
  std::vector<std::string> lines;  ///< without line ends, as bytes of the file; none where the text has no such place
  int marked_line = 0;             ///< index of the place's line in `lines`
  int marked_byte = 0;             ///< of the place in that line
};

/// The excerpt of each place, in their order; empty for a place without a line and for one beyond the text. One pass
/// over `text`, whose lines end as PlaceFinder has it.
[[nodiscard]] std::vector<TextExcerpt> make_excerpts(std::string_view text, std::span<const TextPlace> places);

}  // namespace marey
