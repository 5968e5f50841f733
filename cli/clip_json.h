#pragma once

#include <string>

#include "core/bvh/bvh_clip.h"

namespace marey::cli {

/// What `marey info --json` prints. Bytes of the file that are not UTF-8 come out as U+FFFD.
[[nodiscard]] std::string clip_json(const BvhClip& clip);

}  // namespace marey::cli
