#pragma once

#include <string>

#include "core/bvh/bvh_clip.h"

namespace marey {

/// Writes a BVH file in the given style. Reading the result gives back the same bits for every sample, offset and the
/// frame time, whatever the style: a number whose styled form would lose bits is written in its shortest exact form.
/// Text behind the motion is left out if it would be read as further frames.
[[nodiscard]] std::string write_bvh(const Skeleton& skeleton, const Motion& motion, const BvhStyle& style);

}  // namespace marey
