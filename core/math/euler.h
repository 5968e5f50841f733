#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "core/math/axis.h"

namespace marey {

/// Rotation about one axis: right-handed, active, on column vectors.
[[nodiscard]] glm::dquat axis_rotation(Axis axis, double angle_deg);

/// Product from left to right, R = R_axes[0](angles_deg[0]) * R_axes[1](angles_deg[1]) * ..., of any number of axes
/// with any repeats; identity for none. Both spans have the same length.
[[nodiscard]] glm::dquat rotation_from_euler(std::span<const Axis> axes, std::span<const double> angles_deg);

/// Three axes about which every rotation can be described: no two neighbours are equal. There are twelve.
struct EulerOrder {
  Axis first = Axis::Z;
  Axis second = Axis::X;
  Axis third = Axis::Y;
  friend bool operator==(const EulerOrder&, const EulerOrder&) = default;
};

/// The order that a list of axes is; nothing when it is not one of the twelve.
[[nodiscard]] std::optional<EulerOrder> find_euler_order(std::span<const Axis> axes);

[[nodiscard]] glm::dquat rotation_from_euler(EulerOrder order, const glm::dvec3& angles_deg);

/// Canonical angles in degrees: the middle one in [-90, 90] for three different axes, in [0, 180] where the first axis
/// comes back; the outer ones in [-180, 180]. In gimbal lock the third angle is 0. `rotation` is orthonormal.
[[nodiscard]] glm::dvec3 euler_from_rotation(EulerOrder order, const glm::dmat3& rotation);

/// Of all angles that give `rotation` those nearest to `previous_deg`: both solutions and whole turns are tried. In
/// gimbal lock the third angle stays that of `previous_deg`.
[[nodiscard]] glm::dvec3 euler_near(EulerOrder order, const glm::dmat3& rotation, const glm::dvec3& previous_deg);

/// Angle of the rotation about `axis` that is nearest to `rotation` (least squares over the matrix), [-180, 180].
[[nodiscard]] double hinge_angle_from_rotation(Axis axis, const glm::dmat3& rotation);

}  // namespace marey
