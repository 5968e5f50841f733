#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/bvh/bvh_clip.h"
#include "core/document/document.h"

namespace marey::app {

/// Whether a file is a CSV table, by its name.
[[nodiscard]] bool is_table(std::string_view file_name);

/// Reads a CSV table that a person opens: one of points, or one of channels for the figure of `open_document`, null where
/// none is open. Errors: those of read_points_table() and read_channel_table().
[[nodiscard]] Result<BvhClip> read_opened_table(std::string_view bytes, const Document* open_document);

}  // namespace marey::app
