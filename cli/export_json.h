#pragma once

#include <string>

#include "core/interchange/export.h"

namespace marey::cli {

/// {"targets": [...]}: what `marey targets --json` prints.
[[nodiscard]] std::string targets_json();

/// What an export did and costs: what `marey convert --for TARGET --json` prints.
[[nodiscard]] std::string export_json(ExportTarget target, const ExportedClip& clip);

}  // namespace marey::cli
