#pragma once

#include <glm/gtc/quaternion.hpp>
#include <vector>

#include "core/math/axis.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// Which joint is whose counterpart on the other side of the body.
struct MirrorPairing {
  std::vector<JointIndex> partner;   ///< per joint; the joint itself in the middle, or where none was found
  std::vector<JointIndex> unpaired;  ///< joints of a side without a counterpart, rising
};

/// From the roots down: children of counterparts are paired, left with right, by their names (which differ in little more
/// than the side), else by their place among the offsets. Sides are those of compute_body_sides().
[[nodiscard]] MirrorPairing find_mirror_pairs(const Skeleton& skeleton);

/// The axis across the body: of the two along the ground the one along which counterparts are farther apart in the rest
/// pose; without any the first of X, Z and Y that is not `up`.
[[nodiscard]] Axis find_lateral_axis(const Skeleton& skeleton, const MirrorPairing& pairing, Axis up);

/// Per joint the rotation C that brings the bones below it onto the mirror image of its counterpart's: the identity where they
/// lie there already, within 2 % of the stature, as in figures whose rest pose is its own mirror image. Other ones are mirrored
/// by R' = C_parent^-1 M R M C, where C of a counterpart is M C^-1 M.
[[nodiscard]] std::vector<glm::dquat> find_mirror_corrections(const Skeleton& skeleton, const MirrorPairing& pairing, Axis axis);

/// Joints whose OFFSET is not even by these rotations the mirror image of their counterpart's, by more than 2 % of the
/// stature; roots do not count. A mirrored movement is no mirror image there.
[[nodiscard]] std::vector<JointIndex> find_unsymmetric_joints(const Skeleton& skeleton, const MirrorPairing& pairing, Axis axis);

}  // namespace marey
