#pragma once

#include <string>

#include "core/interchange/export.h"

namespace marey::test {

/// Why an exported clip does not meet a requirement; empty if it does.
[[nodiscard]] std::string fault_of(const ExportedClip& clip, Requirement requirement);

/// The greatest distance of a node that is left from where the clip has it, over all frames; by the pose functions, one
/// frame at a time.
[[nodiscard]] double largest_distance(const Clip& clip, const ExportedClip& exported);

/// The change of this kind, or null.
[[nodiscard]] const ExportChange* find_change(const ExportedClip& clip, ExportChangeKind kind);

/// "names_changed: 2 names change ..." for messages of tests.
[[nodiscard]] std::string listing(const ExportedClip& clip);

}  // namespace marey::test
