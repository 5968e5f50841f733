#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "core/math/angle.h"
#include "core/math/sincos.h"

namespace marey {

/// Axis times angle in radians, of the short way round: the angle is in [0, pi]. `q` of any length but 0.
[[nodiscard]] inline glm::dvec3 rotation_vector(const glm::dquat& q) {
  const glm::dvec3 v(q.x, q.y, q.z);
  const double sine = glm::length(v);
  if (sine == 0.0) return glm::dvec3(0.0);
  const double angle = 2.0 * std::atan2(sine, std::abs(q.w));
  return v * ((q.w < 0.0 ? -angle : angle) / sine);
}

/// The rotation about a vector by its length in radians.
[[nodiscard]] inline glm::dquat rotation_by(const glm::dvec3& vector) {
  const double angle = glm::length(vector);
  if (angle == 0.0) return {1.0, 0.0, 0.0, 0.0};
  const SinCos<double> half = sincos_deg(to_degrees(0.5 * angle));
  const glm::dvec3 v = vector * (half.sine / angle);
  return {half.cosine, v.x, v.y, v.z};
}

}  // namespace marey
