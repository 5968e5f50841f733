#pragma once

#include "core/interchange/rig.h"
#include "core/math/euler.h"

namespace marey {

/// Gives every joint (or, with `only_rotating`, every joint that rotates) three rotations about three axes. Where its
/// own rotations fit, the missing ones are put between them and stay 0; else the angles are solved.
void give_three_rotations(Rig& rig, bool only_rotating, ExportChanges& changes);

/// Gives every joint three rotations in one order, in the same way.
void give_one_order(Rig& rig, EulerOrder order, ExportChanges& changes);

}  // namespace marey
