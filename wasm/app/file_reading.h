#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/bvh/bvh_clip.h"
#include "core/document/document.h"

namespace marey::app {

/// Reads what a person opens: a BVH file; or, by its name, a CSV table of points, or one of channels for the figure of
/// `open_document`, null where none is open.
/// Errors: those of read_bvh(), read_points_table() and read_channel_table().
[[nodiscard]] Result<BvhClip> read_opened_file(std::string_view file_name, std::string_view bytes,
                                               const Document* open_document);

}  // namespace marey::app
