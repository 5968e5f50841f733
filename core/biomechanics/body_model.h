#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// A rigid segment that a joint carries: what hangs on its frame, from the joint towards its children. SI, in the joint's own
/// axes, which turn with it and stand like the world's in the rest pose.
struct Segment {
  JointIndex joint = 0;
  double mass_kg = 0.0;
  glm::dvec3 com_m{0.0};           ///< centre of mass, from the joint's origin
  glm::dmat3 inertia_kgm2{0.0};    ///< about the centre of mass; symmetric
  friend bool operator==(const Segment&, const Segment&) = default;
};

inline constexpr double kGravity_mps2 = 9.81;

/// The masses of a figure. A joint may carry several segments, or none.
struct BodyModel {
  std::vector<Segment> segments;
  std::optional<double> metres_per_unit;       ///< of the clip's unit of length; none: as the clip has it
  std::optional<glm::dvec3> gravity_mps2;      ///< none: 9.81 down the clip's up axis
  friend bool operator==(const BodyModel&, const BodyModel&) = default;
};

/// A symmetric tensor from its moments and products: xx yy zz xy xz yz, the products as they stand in the matrix.
[[nodiscard]] glm::dmat3 symmetric_tensor(std::span<const double, 6> moments);

/// All that a joint carries as one rigid segment, by the parallel axis theorem; nothing where it carries none.
[[nodiscard]] std::optional<Segment> find_whole_segment(const BodyModel& model, JointIndex joint);

/// The moments and products of a symmetric tensor, in the order of symmetric_tensor().
[[nodiscard]] std::array<double, 6> moments_of(const glm::dmat3& tensor);

/// Whether a segment can be, as in check_body_model(); the message names it by the joint's name.
[[nodiscard]] Status check_segment(const Segment& segment, std::string_view joint_name);

/// Whether the masses can be: finite, masses and principal moments >= 0, joints that the figure has, some mass at all. Refused
/// with InvalidArgument, the message names the segment.
[[nodiscard]] Status check_body_model(const BodyModel& model, const Skeleton& skeleton);

/// A model's own, or 9.81 m/s2 down the up axis.
[[nodiscard]] glm::dvec3 find_gravity(const std::optional<glm::dvec3>& own_mps2, Axis up);

[[nodiscard]] double total_mass_kg(const BodyModel& model);

}  // namespace marey
