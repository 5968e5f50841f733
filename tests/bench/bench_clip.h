#pragma once

#include <string>

#include "core/bvh/bvh_clip.h"

namespace marey::bench {

/// The file that every part of `npm run bench` reads, named by MAREY_BENCH_CLIP; scripts/bench/clip.mjs makes it.
/// Ends the program with a message where it is not there.
[[nodiscard]] const std::string& clip_text();

/// The same, read.
[[nodiscard]] const BvhClip& clip();

/// The clip of MAREY_BENCH_BODY: a figure of 20 joints, 10,000 frames.
[[nodiscard]] BvhClip body_clip();

}  // namespace marey::bench
