#pragma once

#include <optional>
#include <string>

#include "cli/input.h"
#include "core/bvh/bvh_clip.h"

namespace marey::cli {

/// The clip in a table: channels of the figure in the BVH file `figure`, or points where that is empty. Failure and
/// findings are reported.
[[nodiscard]] std::optional<BvhClip> read_table(const Input& input, const std::string& figure);

}  // namespace marey::cli
