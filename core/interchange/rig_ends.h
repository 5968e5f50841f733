#pragma once

#include "core/interchange/rig.h"

namespace marey {

/// Takes the names of End Sites away.
void drop_end_site_names(Rig& rig, ExportChanges& changes);

/// Leaves no End Site at joints with children, and one at the others.
void drop_inner_end_sites(Rig& rig, ExportChanges& changes);

/// Gives each limb an End Site that goes on from its last bone by a quarter of its length, or by 1 up where that has none.
void close_limbs(Rig& rig, ExportChanges& changes);

/// Notes bones without length.
void note_bones_without_length(const Rig& rig, ExportChanges& changes);

}  // namespace marey
