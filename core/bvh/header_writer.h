#pragma once

#include <string>

#include "core/bvh/style.h"
#include "core/motion/motion.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// Appends all that stands before the first sample: the text it was read from, with the numbers exchanged that changed,
/// or a newly printed header where that text does not fit the skeleton.
void append_header(const Skeleton& skeleton, const Motion& motion, const BvhStyle& style, std::string& out);

}  // namespace marey
