#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace marey {

inline constexpr double kDegreesPerRadian = 57.295779513082320876798;

[[nodiscard]] constexpr double to_radians(double angle_deg) { return angle_deg * (1.0 / kDegreesPerRadian); }
[[nodiscard]] constexpr double to_degrees(double angle_rad) { return angle_rad * kDegreesPerRadian; }

/// The same direction as `angle_deg`, by whole turns as near to `reference_deg` as it gets.
[[nodiscard]] inline double nearest_turn(double angle_deg, double reference_deg) {
  return angle_deg + 360.0 * std::round((reference_deg - angle_deg) / 360.0);
}

[[nodiscard]] inline glm::dvec3 nearest_turn(const glm::dvec3& angles_deg, const glm::dvec3& reference_deg) {
  return angles_deg + 360.0 * glm::round((reference_deg - angles_deg) / 360.0);
}

}  // namespace marey
