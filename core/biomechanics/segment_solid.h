#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "core/biomechanics/body_model.h"

namespace marey {

/// A symmetric tensor in the axes in which it has no products.
struct PrincipalMoments {
  glm::dvec3 moments{0.0};  ///< in the order of the axes, in no other
  glm::dmat3 axes{1.0};     ///< columns: unit, at right angles, right-handed; those of the tensor where it is diagonal
};

/// Cyclic Jacobi rotations (Golub and Van Loan, Matrix Computations, 8.5): good for equal moments too, whose axes are any that
/// span their plane. What is not finite gives what is not finite.
[[nodiscard]] PrincipalMoments find_principal_moments(const glm::dmat3& tensor);

/// A solid of even density that turns as a segment does, in the axes of the segment's joint, its middle the centre of mass.
struct SegmentSolid {
  glm::dmat3 axes{1.0};         ///< as in PrincipalMoments
  glm::dvec3 half_axes_m{0.0};  ///< of an ellipsoid; 0 across a uniform rod, and all 0 without mass
};

/// From I_i = m (a_j^2 + a_k^2) / 5: a_i^2 = 5 (I_j + I_k - I_i) / 2 m. A tensor that no body can have, one moment above the sum
/// of the two others, has a half axis of 0 in place of an imaginary one.
[[nodiscard]] SegmentSolid find_segment_solid(const Segment& segment);

}  // namespace marey
