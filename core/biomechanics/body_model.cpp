#include "core/biomechanics/body_model.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numeric>

namespace marey {
namespace {

bool is_finite(const Segment& segment) {
  bool finite = std::isfinite(segment.mass_kg);
  for (int i = 0; i < 3; ++i) {
    finite = finite && std::isfinite(segment.com_m[i]);
    for (int k = 0; k < 3; ++k) finite = finite && std::isfinite(segment.inertia_kgm2[i][k]);
  }
  return finite;
}

/// Sylvester's rule for all principal minors, with room for rounding.
bool is_semidefinite(const glm::dmat3& m) {
  const double size = std::abs(m[0][0]) + std::abs(m[1][1]) + std::abs(m[2][2]);
  const auto minor = [&](int i, int k) { return m[i][i] * m[k][k] - m[i][k] * m[k][i]; };
  bool good = glm::determinant(m) >= -1e-9 * size * size * size;
  for (int i = 0; i < 3; ++i) good = good && m[i][i] >= -1e-9 * size && minor(i, (i + 1) % 3) >= -1e-9 * size * size;
  return good;
}

}  // namespace

glm::dmat3 symmetric_tensor(std::span<const double, 6> moments) {
  const auto [xx, yy, zz] = std::array{moments[0], moments[1], moments[2]};
  const auto [xy, xz, yz] = std::array{moments[3], moments[4], moments[5]};
  return {xx, xy, xz, xy, yy, yz, xz, yz, zz};
}

std::array<double, 6> moments_of(const glm::dmat3& t) { return {t[0][0], t[1][1], t[2][2], t[0][1], t[0][2], t[1][2]}; }

std::optional<Segment> find_whole_segment(const BodyModel& model, JointIndex joint) {
  std::optional<Segment> whole;
  glm::dvec3 moment(0.0);
  for (const Segment& segment : model.segments) {
    if (segment.joint != joint) continue;
    if (!whole) whole = Segment{joint, 0.0, segment.com_m, glm::dmat3(0.0)};
    whole->mass_kg += segment.mass_kg;
    moment += segment.mass_kg * segment.com_m;
  }
  if (!whole) return whole;
  if (whole->mass_kg > 0.0) whole->com_m = moment / whole->mass_kg;
  for (const Segment& segment : model.segments) {
    if (segment.joint != joint) continue;
    const glm::dvec3 arm = segment.com_m - whole->com_m;
    whole->inertia_kgm2 += segment.inertia_kgm2 + segment.mass_kg * (glm::dmat3(glm::dot(arm, arm)) - glm::outerProduct(arm, arm));
  }
  return whole;
}

Status check_segment(const Segment& segment, std::string_view joint_name) {
  const auto refusal = [&](std::string_view what) {
    return Error{DiagnosticCode::InvalidArgument, {}, fmt::format("The segment of {} has {}.", joint_name, what), {}, {}};
  };
  if (!is_finite(segment)) return refusal("a number that is not finite");
  if (segment.mass_kg < 0.0) return refusal("a mass below 0");
  if (!is_semidefinite(segment.inertia_kgm2)) return refusal("an inertia that no body has: a principal moment is below 0");
  return {};
}

Status check_body_model(const BodyModel& model, const Skeleton& skeleton) {
  const auto refusal = [](std::string message) { return Error{DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; };
  for (std::size_t i = 0; i < model.segments.size(); ++i) {
    const Segment& segment = model.segments[i];
    if (segment.joint < 0 || segment.joint >= skeleton.joint_count()) {
      return refusal(fmt::format("Segment {} hangs on a joint that the figure does not have.", i + 1));
    }
    if (Status status = check_segment(segment, skeleton.name(segment.joint)); !status) return status;
  }
  if (model.metres_per_unit && !(*model.metres_per_unit > 0.0 && std::isfinite(*model.metres_per_unit))) {
    return refusal("The metres of a unit are a number above 0.");
  }
  if (total_mass_kg(model) <= 0.0) return refusal("The body has no mass.");
  return {};
}

glm::dvec3 find_gravity(const std::optional<glm::dvec3>& own_mps2, Axis up) {
  glm::dvec3 usual(0.0);
  usual[static_cast<int>(up)] = -kGravity_mps2;
  return own_mps2.value_or(usual);
}

double total_mass_kg(const BodyModel& model) {
  return std::accumulate(model.segments.begin(), model.segments.end(), 0.0,
                         [](double sum, const Segment& segment) { return sum + segment.mass_kg; });
}

}  // namespace marey
