#pragma once

#include <string>
#include <vector>

#include "cli/channel_limits.h"
#include "core/base/result.h"
#include "core/bvh/bvh_clip.h"
#include "core/lint/lint.h"

namespace marey::cli {

/// What a command with --json prints for a file that is refused: {"error": {"code", "line", "column", "message"}}.
[[nodiscard]] std::string refusal_json(const Error& error);

/// What `marey check --json` prints about a file of this name. Frames are numbered from 1.
[[nodiscard]] std::string check_json(const std::string& file, const BvhClip& clip, const LintReport& lint,
                                     const std::vector<Violation>& violations);

/// What `marey info --json` prints.
[[nodiscard]] std::string clip_json(const BvhClip& clip);

}  // namespace marey::cli
