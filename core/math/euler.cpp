#include "core/math/euler.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/math/angle.h"
#include "core/math/sincos.h"

namespace marey {
namespace {

// Below this cosine (sine, where the first axis comes back) of the middle angle only a + c or a - c is defined.
constexpr double kGimbalLock = 1e-9;

// Formulas are written as in the text books: entry(R, row, column).
double entry(const glm::dmat3& matrix, int row, int column) { return matrix[column][row]; }

double atan2_deg(double y, double x) { return to_degrees(std::atan2(y, x)); }

// Numbers of the axes, i == k for proper Euler angles; `other` is the axis that is neither the first nor the second.
struct Axes {
  int i, j, k, other;
  double parity;  // +1 when (i, j, other) is an even permutation of x, y, z
  bool proper;
};

Axes numbered(EulerOrder order) {
  const int i = static_cast<int>(order.first);
  const int j = static_cast<int>(order.second);
  const int k = static_cast<int>(order.third);
  return {i, j, k, 3 - i - j, (i + 1) % 3 == j ? 1.0 : -1.0, i == k};
}

struct LeadingAngles {
  double first_deg;
  double middle_deg;
  bool gimbal_lock;
};

LeadingAngles tait_bryan(const Axes& axes, const glm::dmat3& r) {
  const auto [i, j, k, other, e, proper] = axes;
  const double cosine = std::hypot(entry(r, i, i), entry(r, i, j));
  return {atan2_deg(-e * entry(r, j, k), entry(r, k, k)), atan2_deg(e * entry(r, i, k), cosine), cosine < kGimbalLock};
}

LeadingAngles proper_euler(const Axes& axes, const glm::dmat3& r) {
  const auto [i, j, last, k, e, proper] = axes;
  const double sine = std::hypot(entry(r, i, j), entry(r, i, k));
  return {atan2_deg(entry(r, j, i), -e * entry(r, k, i)), atan2_deg(sine, entry(r, i, i)), sine < kGimbalLock};
}

// The third angle from what R_first(-a) leaves of the rotation: its row j holds c alone. Taken from R itself, c would
// not fit a near gimbal lock, where both lose digits.
double third_angle_deg(const Axes& axes, const glm::dmat3& r, double first_deg) {
  const auto [i, j, last, k, e, proper] = axes;
  const SinCos<double> a = sincos_deg(first_deg);
  const int column = proper ? k : i;
  const double sine = a.cosine * entry(r, j, column) + e * a.sine * entry(r, k, column);
  return atan2_deg((proper ? -e : e) * sine, a.cosine * entry(r, j, j) + e * a.sine * entry(r, k, j));
}

// With the third angle c given, what R * R_third(-c) turns about the first axis.
double first_angle_deg(const Axes& axes, EulerOrder order, const glm::dmat3& r, double third_deg) {
  const glm::dmat3 q = r * glm::mat3_cast(axis_rotation(order.third, -third_deg));
  return atan2_deg(axes.parity * entry(q, axes.other, axes.j), entry(q, axes.j, axes.j));
}

glm::dvec3 extracted(EulerOrder order, const glm::dmat3& r, double third_in_gimbal_lock_deg) {
  const Axes axes = numbered(order);
  const LeadingAngles found = axes.proper ? proper_euler(axes, r) : tait_bryan(axes, r);
  if (found.gimbal_lock) {
    return {first_angle_deg(axes, order, r, third_in_gimbal_lock_deg), found.middle_deg, third_in_gimbal_lock_deg};
  }
  return {found.first_deg, found.middle_deg, third_angle_deg(axes, r, found.first_deg)};
}

double squared_distance(const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a - b, a - b); }

}  // namespace

glm::dquat axis_rotation(Axis axis, double angle_deg) {
  const SinCos<double> half = sincos_deg(0.5 * angle_deg);
  glm::dquat rotation(half.cosine, 0.0, 0.0, 0.0);
  rotation[static_cast<int>(axis)] = half.sine;
  return rotation;
}

glm::dquat rotation_from_euler(std::span<const Axis> axes, std::span<const double> angles_deg) {
  glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
  for (std::size_t i = 0; i < axes.size(); ++i) rotation = rotation * axis_rotation(axes[i], angles_deg[i]);
  return rotation;
}

std::optional<EulerOrder> find_euler_order(std::span<const Axis> axes) {
  if (axes.size() != 3 || axes[0] == axes[1] || axes[1] == axes[2]) return std::nullopt;
  return EulerOrder{axes[0], axes[1], axes[2]};
}

glm::dquat rotation_from_euler(EulerOrder order, const glm::dvec3& angles_deg) {
  return axis_rotation(order.first, angles_deg.x) * axis_rotation(order.second, angles_deg.y) *
         axis_rotation(order.third, angles_deg.z);
}

glm::dvec3 euler_from_rotation(EulerOrder order, const glm::dmat3& rotation) { return extracted(order, rotation, 0.0); }

glm::dvec3 euler_near(EulerOrder order, const glm::dmat3& rotation, const glm::dvec3& previous_deg) {
  const glm::dvec3 found = extracted(order, rotation, previous_deg.z);
  const bool proper = order.first == order.third;
  const glm::dvec3 twin(found.x + 180.0, proper ? -found.y : 180.0 - found.y, found.z + 180.0);
  const glm::dvec3 first = nearest_turn(found, previous_deg);
  const glm::dvec3 second = nearest_turn(twin, previous_deg);
  return squared_distance(second, previous_deg) < squared_distance(first, previous_deg) ? second : first;
}

double hinge_angle_from_rotation(Axis axis, const glm::dmat3& rotation) {
  const int j = (static_cast<int>(axis) + 1) % 3;
  const int k = (static_cast<int>(axis) + 2) % 3;
  return atan2_deg(entry(rotation, k, j) - entry(rotation, j, k), entry(rotation, j, j) + entry(rotation, k, k));
}

}  // namespace marey
