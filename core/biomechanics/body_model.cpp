#include "core/biomechanics/body_model.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
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
  for (int i = 0; i < 3; ++i) good = good && m[i][i] >= 0.0 && minor(i, (i + 1) % 3) >= -1e-9 * size * size;
  return good;
}

}  // namespace

glm::dmat3 symmetric_tensor(std::span<const double, 6> moments) {
  const auto [xx, yy, zz] = std::array{moments[0], moments[1], moments[2]};
  const auto [xy, xz, yz] = std::array{moments[3], moments[4], moments[5]};
  return {xx, xy, xz, xy, yy, yz, xz, yz, zz};
}

Status check_body_model(const BodyModel& model, const Skeleton& skeleton) {
  const auto refusal = [](std::string message) { return Error{DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; };
  for (std::size_t i = 0; i < model.segments.size(); ++i) {
    const Segment& segment = model.segments[i];
    if (segment.joint < 0 || segment.joint >= skeleton.joint_count()) {
      return refusal(fmt::format("Segment {} hangs on a joint that the figure does not have.", i + 1));
    }
    const std::string& name = skeleton.name(segment.joint);
    if (!is_finite(segment)) return refusal(fmt::format("The segment of {} has a number that is not finite.", name));
    if (segment.mass_kg < 0.0) return refusal(fmt::format("The segment of {} has a mass below 0.", name));
    if (!is_semidefinite(segment.inertia_kgm2)) {
      return refusal(fmt::format("The segment of {} has an inertia that no body has: a principal moment is below 0.", name));
    }
  }
  if (model.metres_per_unit && !(*model.metres_per_unit > 0.0 && std::isfinite(*model.metres_per_unit))) {
    return refusal("The metres of a unit are a number above 0.");
  }
  if (total_mass_kg(model) <= 0.0) return refusal("The body has no mass.");
  return {};
}

double total_mass_kg(const BodyModel& model) {
  return std::accumulate(model.segments.begin(), model.segments.end(), 0.0,
                         [](double sum, const Segment& segment) { return sum + segment.mass_kg; });
}

}  // namespace marey
