#pragma once

#include <string>

#include "core/base/diagnostic.h"
#include "core/bvh/bvh_clip.h"
#include "core/lint/lint.h"

namespace marey::cli {

/// What the reader and the linter found, as lines on standard error: "walk.bvh: note: <what> <what to do> <who stumbles>".
/// Where both noted the same, it is one line with the reader's place.
void report_check(const std::string& file, const Diagnostics& diagnostics, const LintReport& lint);

}  // namespace marey::cli
