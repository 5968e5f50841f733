#include "wasm/app/picking.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace marey::app {
namespace {

struct Approach {
  double depth = 0.0;     // along the ray
  double distance = 0.0;  // between ray and solid's middle line there
};

// The closest approach of a ray and a segment, which may be a point.
Approach closest_approach(const CameraView::Ray& ray, const PickSolid& solid) {
  const glm::dvec3 segment = solid.to - solid.from;
  const glm::dvec3 offset = solid.from - ray.origin;
  const double length_squared = glm::dot(segment, segment);
  const double slant = glm::dot(segment, ray.direction);
  const double area = length_squared - slant * slant;
  double share = 0.0;
  if (length_squared > 0.0) {
    const double along_segment = glm::dot(offset, segment);
    const double along_ray = glm::dot(offset, ray.direction);
    // Parallel to the ray every share is as good; the end nearer to the eye is seen.
    share = area > 1e-12 * length_squared ? (slant * along_ray - along_segment) / area : (slant > 0.0 ? 0.0 : 1.0);
    share = std::clamp(share, 0.0, 1.0);
  }
  const glm::dvec3 point = offset + segment * share;
  const double depth = glm::dot(point, ray.direction);
  return {depth, glm::length(point - ray.direction * depth)};
}

}  // namespace

JointIndex pick_joint(std::span<const PickSolid> solids, const CameraView& camera, const glm::dvec2& pointer,
                      double tolerance) {
  const CameraView::Ray ray = camera.ray(pointer);
  JointIndex hit = kNoParent;
  JointIndex near_miss = kNoParent;
  double nearest_surface = std::numeric_limits<double>::max();
  double smallest_gap = tolerance;
  for (const PickSolid& solid : solids) {
    const Approach approach = closest_approach(ray, solid);
    const double units_per_pixel = camera.units_per_pixel(approach.depth);
    if (approach.depth <= 0.0 || units_per_pixel <= 0.0) continue;
    if (approach.distance <= solid.radius) {
      const double surface =
          approach.depth - std::sqrt(solid.radius * solid.radius - approach.distance * approach.distance);
      if (surface < nearest_surface) {
        nearest_surface = surface;
        hit = solid.joint;
      }
    } else if (const double gap = (approach.distance - solid.radius) / units_per_pixel; gap <= smallest_gap) {
      smallest_gap = gap;
      near_miss = solid.joint;
    }
  }
  return hit != kNoParent ? hit : near_miss;
}

}  // namespace marey::app
