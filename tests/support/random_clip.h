#pragma once

#include "core/motion/motion.h"
#include "core/skeleton/skeleton.h"
#include "tests/support/random.h"

namespace marey::test {

/// A tree of up to `most_joints` joints with odd channel sets, names, roots and end sites.
[[nodiscard]] Skeleton random_skeleton(Random& random, int most_joints);

/// A motion whose samples mix whole numbers, few decimals, all bits, zeros of both signs and denormals.
[[nodiscard]] Motion random_motion(Random& random, int channel_count, int frame_count);

/// One such sample.
[[nodiscard]] double random_sample(Random& random);

}  // namespace marey::test
