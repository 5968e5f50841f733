#pragma once

#include <glm/vec3.hpp>

#include "core/motion/motion.h"
#include "core/skeleton/channel.h"
#include "core/skeleton/position_rule.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// Axis-aligned box in world space, file units. low <= high per axis.
struct Box {
  glm::dvec3 low{0.0};
  glm::dvec3 high{0.0};

  [[nodiscard]] glm::dvec3 center() const { return (low + high) * 0.5; }
  [[nodiscard]] glm::dvec3 size() const { return high - low; }
};

/// Box around all nodes over at most `max_samples` frames spread evenly over the clip (first and last included).
[[nodiscard]] Box compute_clip_bounds(const Skeleton& skeleton, const Motion& motion, PositionRule rule,
                                      int max_samples = 256);

/// The axis that most likely points up: the axis along which the rest pose and the first frames stand, that is the
/// head-most long extent of the figure; Y when the evidence is equal (BVH's habit). X is never chosen.
[[nodiscard]] Axis find_up_axis(const Skeleton& skeleton, const Motion& motion, PositionRule rule);

/// Height of the ground along `up` in file units: a low percentile of the lowest node over the clip, so that one bad
/// frame does not sink it; 0 when the clip hangs or swings freely around the origin (the lowest point is further
/// below 0 than a tenth of the stature and a root stays at the origin).
[[nodiscard]] double find_ground_height(const Skeleton& skeleton, const Motion& motion, PositionRule rule, Axis up);

}  // namespace marey
