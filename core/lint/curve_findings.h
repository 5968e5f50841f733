#pragma once

#include "core/lint/lint.h"

namespace marey {

/// Jumps and spikes of one frame in the curves of rotations and positions within `frames`. Those of several channels at
/// about the same time are one finding.
void add_curve_findings(const Clip& clip, FrameRange frames, const LintOptions& options, LintReport& report);

}  // namespace marey
