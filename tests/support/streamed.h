#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "core/bvh/stream_reader.h"

namespace marey::test {

/// Gives the size of the next piece, > 0.
using NextPiece = std::function<std::size_t()>;

/// Feeds `text` in pieces. What differs from read_bvh() of the whole, for people; empty if nothing does. `was_streamed`, if
/// given, tells whether frames were read before the end.
[[nodiscard]] std::string difference_when_streamed(std::string_view text, const StreamOptions& options,
                                                   const NextPiece& next_piece, bool* was_streamed = nullptr);

}  // namespace marey::test
