#pragma once

#include <vector>

#include "core/base/text_cursor.h"
#include "core/bvh/report.h"
#include "core/bvh/style.h"
#include "core/skeleton/channel.h"

namespace marey {

inline constexpr int kMostOffsetValues = 6;

/// What stands behind the word OFFSET.
struct OffsetRead {
  std::vector<NumberSlot> values;  ///< the first kMostOffsetValues; always finite
  int count = 0;                   ///< of all values, 3 in a sound file
  bool repaired = false;           ///< the text does not say plainly what was read
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
  bool repaired = false;
};

/// Reads count and names behind CHANNELS. The names win over the count; at most `most` are read.
[[nodiscard]] ChannelsRead read_channel_names(TextCursor& cursor, int most, Report& report);

/// Passes blanks and comments ("#" or "//" to the end of the line), each comment reported.
void skip_blanks_and_comments(TextCursor& cursor, Report& report);

}  // namespace marey
