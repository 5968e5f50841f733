#pragma once

#include "core/interchange/rig.h"

namespace marey {

/// One frame with the rest pose, for a clip without frames.
[[nodiscard]] Motion rest_frame(const Clip& clip, ExportChanges& changes);

/// Puts the rest pose in front: all angles 0, the roots where the first frame has them, all else at its OFFSET. Nothing
/// where the first frame is so already (to 0.01 degrees).
void add_reference_pose(Rig& rig, ExportChanges& changes);

}  // namespace marey
