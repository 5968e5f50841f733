#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/biomechanics/body_model.h"
#include "core/bvh/bvh_clip.h"
#include "core/document/document.h"

namespace marey::app {

/// Whether a file is a CSV table, by its name.
[[nodiscard]] bool is_table(std::string_view file_name);

/// Reads a model for the joints of a figure. Errors: what is no JSON, with its place, and those of read_body_model().
[[nodiscard]] Result<BodyModel> read_opened_model(std::string_view bytes, const Skeleton& skeleton);

/// Reads a CSV table that a person opens: one of points, or one of channels for the figure of `open_document`, null where
/// none is open. Errors: those of read_points_table() and read_channel_table().
[[nodiscard]] Result<BvhClip> read_opened_table(std::string_view bytes, const Document* open_document);

}  // namespace marey::app
