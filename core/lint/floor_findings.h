#pragma once

#include "core/lint/lint.h"

namespace marey {

/// Frames in which the lowest end of the figure is below the floor that it stands on in most of `frames`. Nothing for a
/// figure that does not stand, such as one that swings or flies.
void add_floor_findings(const Clip& clip, FrameRange frames, const LintOptions& options, LintReport& report);

}  // namespace marey
