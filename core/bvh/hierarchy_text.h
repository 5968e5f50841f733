#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/text_cursor.h"
#include "core/bvh/header_patch.h"
#include "core/bvh/joint_lines.h"
#include "core/bvh/limits.h"
#include "core/bvh/offset_repair.h"
#include "core/bvh/report.h"

namespace marey {

/// ROOT, JOINT or End Site with what stands in its block. Places are bytes of the text.
struct RawBlock {
  enum class Kind : std::uint8_t { Root, Joint, EndSite };
  Kind kind = Kind::Joint;
  bool has_body = true;  ///< false: the name is not followed by a block
  bool has_offset = false;
  bool has_channels = false;
  bool has_child = false;  ///< a joint or an end site
  std::string_view name;        ///< without blanks at its ends
  std::string_view name_bytes;  ///< with those at its end
  std::size_t place = 0;
  std::size_t keyword_end = 0;  ///< behind ROOT, JOINT or End Site
  std::size_t offset_place = 0;
  std::size_t offset_end = 0;   ///< behind the word OFFSET
  OffsetRead offset;
  std::vector<OffsetReading> offset_readings;  ///< when there are not three values: what they can mean, the best first
  std::vector<RawChannel> channels;
};

/// "'Hips'" or "the end site", for messages.
[[nodiscard]] std::string description_of(const RawBlock& block);

/// Index of a block that has braces but no keyword.
inline constexpr int kNamelessBlock = -1;

/// Opening or closing brace, in the order of the text.
struct BraceEvent {
  int block = kNamelessBlock;  ///< the block that opens; unused when closing
  int closings = 0;            ///< 0: opens; else so many '}' in a row
  std::size_t place = 0;
};

/// The hierarchy as its words say it, before its nesting is checked.
struct HierarchyText {
  std::vector<RawBlock> blocks;  ///< in the order of the text
  std::vector<BraceEvent> events;
  HeaderPatches patches;        ///< where the text says something else than what was understood
  std::size_t end = 0;          ///< where the motion section begins, or the end of the text
};

/// Reads the hierarchy section from the cursor on. Finds words, not lines; keeps going over what it does not know.
/// Stops in front of MOTION or "Frames:", or when the report has failed.
[[nodiscard]] HierarchyText read_hierarchy_text(TextCursor& cursor, const ReadLimits& limits, Report& report);

}  // namespace marey
