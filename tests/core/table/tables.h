#pragma once

#include <string>

#include "core/bvh/bvh_clip.h"

namespace marey::test {

/// The clip's channels as a table.
[[nodiscard]] std::string channel_table(const BvhClip& clip, const std::string& length_unit = {});

/// The world positions of its nodes as a table.
[[nodiscard]] std::string position_table(const BvhClip& clip, const std::string& length_unit = {});

}  // namespace marey::test
