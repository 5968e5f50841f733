#pragma once

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

/// The axis across the body: the one along which counterparts are farthest apart in the rest pose; X without any.
[[nodiscard]] Axis find_lateral_axis(const Skeleton& skeleton, const MirrorPairing& pairing);

/// Joints whose OFFSET is not the mirror image of their counterpart's, by more than 2 % of the stature; roots do not count. A
/// mirrored movement is no mirror image there.
[[nodiscard]] std::vector<JointIndex> find_unsymmetric_joints(const Skeleton& skeleton, const MirrorPairing& pairing, Axis axis);

}  // namespace marey
