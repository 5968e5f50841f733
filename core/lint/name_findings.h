#pragma once

#include "core/lint/lint.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// Names of joints by which other programs cannot find them: one finding per kind.
void add_name_findings(const Skeleton& skeleton, LintReport& report);

}  // namespace marey
