#pragma once

#include "core/lint/lint.h"

namespace marey {

/// Steps within `frames` in which the angles of a joint leap while its rotation goes on: by whole turns of one angle
/// (AngleWrap), or of several angles at once, as beside gimbal lock (GimbalFlip). One finding per joint and kind.
void add_turn_findings(const Clip& clip, FrameRange frames, const LintOptions& options, LintReport& report);

}  // namespace marey
