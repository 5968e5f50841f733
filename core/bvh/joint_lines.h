#pragma once

#include <vector>

#include "core/base/text_cursor.h"
#include "core/bvh/header_patch.h"
#include "core/bvh/report.h"
#include "core/bvh/style.h"
#include "core/skeleton/channel.h"

namespace marey {

inline constexpr int kMostOffsetValues = 6;

/// What stands behind the word OFFSET.
struct OffsetRead {
  std::vector<NumberSlot> values;  ///< the first kMostOffsetValues; always finite
  int count = 0;                   ///< of all values, 3 in a sound file
  std::size_t end = 0;             ///< behind the last value
  HeaderPatches patches;           ///< where the text does not say plainly what was read
};

/// Reads the numbers behind OFFSET, wherever the line ends are.
[[nodiscard]] OffsetRead read_offset_values(TextCursor& cursor, Report& report);

/// One channel as written behind CHANNELS.
struct RawChannel {
  ChannelKind kind = ChannelKind::Other;
  std::string_view keyword;
};

/// What stands behind the word CHANNELS.
struct ChannelsRead {
  std::vector<RawChannel> channels;
  HeaderPatches patches;
  std::size_t end = 0;  ///< behind the last name
};

/// Reads count and names behind CHANNELS. The names win over the count; at most `most` are read.
[[nodiscard]] ChannelsRead read_channel_names(TextCursor& cursor, int most, Report& report);

/// Passes blanks and comments in silence.
void pass_blanks_and_comments(TextCursor& cursor);

/// Passes blanks and comments, each comment reported.
void skip_blanks_and_comments(TextCursor& cursor, Report& report);

}  // namespace marey
