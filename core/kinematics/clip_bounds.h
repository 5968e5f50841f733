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
/// Points that are not finite are left out. A clip without frames, or without a finite point, gives the rest pose.
[[nodiscard]] Box compute_clip_bounds(const Skeleton& skeleton, const Motion& motion, PositionRule rule,
                                      int max_samples = 256);

/// The axis that most likely points up, Y or Z: the one along which the figure is tall in the poses of the clip and in
/// its rest pose, where standing on the plane at 0 counts as a stature more (four-legged figures are longer than tall).
/// Y when the evidence is equal (BVH's habit).
[[nodiscard]] Axis find_up_axis(const Skeleton& skeleton, const Motion& motion, PositionRule rule);

/// Height of the ground along `up` in file units: a low percentile of the lowest node over the clip, so that one bad
/// frame does not sink it. 0 when that is about 0, joints being inside of the flesh, and 0 when the clip swings around
/// the origin: a root stays there and the height of the lowest node varies by more than a quarter of the stature.
[[nodiscard]] double find_ground_height(const Skeleton& skeleton, const Motion& motion, PositionRule rule, Axis up);

}  // namespace marey
