#pragma once

#include <cstdint>
#include <vector>

#include "core/motion/clip.h"

namespace marey::test {

/// True if both hold the same bits: samples, offsets, frame time.
[[nodiscard]] bool same_numbers(const Skeleton& a, const Motion& motion_a, const Skeleton& b, const Motion& motion_b);

/// Everything that an edit can change, bit by bit.
[[nodiscard]] std::vector<std::uint64_t> bits_of(const Clip& clip);

}  // namespace marey::test
