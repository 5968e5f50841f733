#pragma once

#include "core/lint/lint.h"

namespace marey {

/// Notes a first frame that is no part of the movement: the figure leaves it in one step and goes on in small ones.
/// True if there is one.
bool add_reference_pose(const Clip& clip, LintReport& report);

}  // namespace marey
