#pragma once

#include "cli/exit_code.h"
#include "core/bvh/bvh_clip.h"

namespace marey::cli {

/// Writes the samples of all channels as CSV.
[[nodiscard]] ExitCode write_channel_table(const std::string& file, const Skeleton& skeleton, const Motion& motion);

/// Writes the world positions of all joints and end sites as CSV.
[[nodiscard]] ExitCode write_position_table(const std::string& file, const BvhClip& clip);

}  // namespace marey::cli
