#include "core/biomechanics/segment_solid.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

namespace marey {
namespace {

constexpr int kMostSweeps = 16;  // the products shrink quadratically: five do

// The turn in the plane of axes p and q that takes their product away.
glm::dmat3 jacobi_rotation(const glm::dmat3& tensor, int p, int q) {
  const double theta = (tensor[q][q] - tensor[p][p]) / (2.0 * tensor[p][q]);
  const double tangent = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
  const double cosine = 1.0 / std::hypot(tangent, 1.0);
  glm::dmat3 rotation(1.0);
  rotation[p][p] = rotation[q][q] = cosine;
  rotation[q][p] = tangent * cosine;
  rotation[p][q] = -tangent * cosine;
  return rotation;
}

}  // namespace

PrincipalMoments find_principal_moments(const glm::dmat3& tensor) {
  glm::dmat3 left = tensor;
  PrincipalMoments found;
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    const double size = std::abs(left[0][0]) + std::abs(left[1][1]) + std::abs(left[2][2]);
    bool is_diagonal = true;
    for (int p = 0; p < 2; ++p) {
      for (int q = p + 1; q < 3; ++q) {
        if (std::abs(left[p][q]) <= 1e-16 * size) continue;
        is_diagonal = false;
        const glm::dmat3 rotation = jacobi_rotation(left, p, q);
        left = glm::transpose(rotation) * left * rotation;
        left[p][q] = left[q][p] = 0.0;
        found.axes = found.axes * rotation;
      }
    }
    if (is_diagonal) break;
  }
  found.moments = {left[0][0], left[1][1], left[2][2]};
  return found;
}

SegmentSolid find_segment_solid(const Segment& segment) {
  SegmentSolid solid;
  if (!(segment.mass_kg > 0.0)) return solid;
  const PrincipalMoments principal = find_principal_moments(segment.inertia_kgm2);
  solid.axes = principal.axes;
  const double sum = principal.moments.x + principal.moments.y + principal.moments.z;
  for (int i = 0; i < 3; ++i) {
    solid.half_axes_m[i] = std::sqrt(std::max(2.5 * (sum - 2.0 * principal.moments[i]) / segment.mass_kg, 0.0));
  }
  return solid;
}

}  // namespace marey
