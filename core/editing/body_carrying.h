#pragma once

#include <glm/mat3x3.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/motion/body_choice.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// What people have said of a body, for a figure whose nodes come from those of another: `origins` has of each node which one
/// it was, kNoParent for a new one. What was said of joints and points that are gone, or that cannot touch the floor any more, is
/// left out, and a note tells it.
[[nodiscard]] BodyChoice carry_body_over(const BodyChoice& body, const Skeleton& before, const Skeleton& after,
                                         std::span<const NodeIndex> origins, std::vector<std::string>& notes);

/// Expresses own segments in other axes: of each joint, what takes the former ones to the new ones.
void turn_own_segments(BodyChoice& body, std::span<const glm::dmat3> rotations);

/// Makes own segments so many times as long, as their bones are; masses stay.
void scale_own_segments(BodyChoice& body, double factor);

}  // namespace marey
