#pragma once

#include "core/base/text_cursor.h"
#include "core/bvh/header_patch.h"
#include "core/bvh/report.h"

namespace marey {

/// Reads the seconds of a frame from the number at the cursor, and moves behind it and what belongs to it: "0.0333 s",
/// "33.3ms", "1/120", "120Hz" and the like, which are put into the format's form by a patch. What is no time gives
/// `fallback_s`. Each assumption is reported.
[[nodiscard]] double read_frame_time(TextCursor& cursor, double fallback_s, HeaderPatches& patches, Report& report);

}  // namespace marey
