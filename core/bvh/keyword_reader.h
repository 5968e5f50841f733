#pragma once

#include <cstddef>
#include <string_view>

#include "core/base/text_cursor.h"
#include "core/bvh/header_patch.h"
#include "core/bvh/keyword.h"
#include "core/bvh/report.h"

namespace marey {

/// Moves behind the keyword at the cursor and behind what is glued to it ("OFFSET:", "CHANNELS3"), and says how it is
/// misspelled. Of "EndSite" only "End" is taken. Precondition: a word that find_keyword() or find_misspelled_keyword()
/// knows as `keyword`.
void take_keyword(TextCursor& cursor, Keyword keyword, HeaderPatches& patches, Report& report);

/// Moves from behind "End" to behind "Site", which may stand in the next line or be joined by a hyphen; a missing one is
/// added. `place` is that of "End".
void take_site(TextCursor& cursor, std::size_t place, HeaderPatches& patches, Report& report);

/// True if `text` begins with a line such as "Motion of a walk" above the hierarchy: HIERARCHY stands alone in a later
/// line, without a block in between. `keyword` is what the line begins with; MOTION alone in a line is never such a text.
[[nodiscard]] bool is_text_before_hierarchy(Keyword keyword, std::string_view text);

}  // namespace marey
