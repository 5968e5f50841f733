#pragma once

#include "core/interchange/export_target.h"
#include "core/interchange/rig.h"

namespace marey {

/// Puts several roots below an added one. Where positions are for the root only, the added root goes where the first
/// root goes, so that the first figure keeps its way; else it stays at the origin.
void join_roots(Rig& rig, bool positions_of_root_only, ExportChanges& changes);

/// Gives the roots all three positions, the missing ones with their OFFSET as value.
void complete_root_positions(Rig& rig, ExportChanges& changes);

/// Joints with some positions get all three.
void complete_positions(Rig& rig, ExportChanges& changes);

/// Joints below the roots lose their positions. OFFSET becomes the median of each axis: a bone that only repeats one
/// place keeps it, and outliers do not count.
void drop_positions_below_root(Rig& rig, ExportChanges& changes);

/// OFFSET 0 0 0 for roots, whose positions then hold the whole place.
void move_root_offset(Rig& rig, ExportChanges& changes);

}  // namespace marey
