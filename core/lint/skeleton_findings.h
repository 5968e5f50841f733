#pragma once

#include "core/lint/lint.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// Shapes of the tree and sets of channels that other programs do not expect: one finding per kind.
void add_skeleton_findings(const Skeleton& skeleton, LintReport& report);

}  // namespace marey
