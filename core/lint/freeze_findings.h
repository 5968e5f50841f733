#pragma once

#include "core/lint/lint.h"

namespace marey {

/// Stretches in which curves that move elsewhere keep exactly one value: all of them together (FrozenFigure), or
/// channels that change with every frame elsewhere (FrozenChannel; those that freeze and wake together are one finding).
void add_freeze_findings(const Clip& clip, const LintOptions& options, LintReport& report);

}  // namespace marey
