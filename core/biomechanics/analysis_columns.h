#pragma once

#include "core/biomechanics/analysed_clip.h"

namespace marey {

/// Adds the columns of one quantity to a table. Precondition: `clip` has found what the quantity is made of.
void add_analysis_columns(const AnalysedClip& clip, const AskedQuantity& asked, AnalysisTable& table);

/// Whether a quantity is made of the file's poses, and whether of their rotations too.
[[nodiscard]] bool needs_poses(const AskedQuantity& asked);
[[nodiscard]] bool needs_rotations(const AskedQuantity& asked);

}  // namespace marey
