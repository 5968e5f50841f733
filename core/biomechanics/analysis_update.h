#pragma once

#include "core/biomechanics/analysis.h"

namespace marey {

/// Whether update_analysis() can do with less than all frames: splines lean on every one of them.
[[nodiscard]] bool can_update_analysis(const Derivation& derivation);

/// Brings a table up to date after the samples of some frames have changed, for as long as a curve is dragged: computes anew these
/// frames and those that lean on them, and leaves the others as they are. Columns are then those of analyse(), with a Butterworth
/// to a millionth, but for whole turns of angles behind the change. Support, floor, contacts and notes stay as they were found.
/// Preconditions: `table` is of the same request and a clip with as many frames; can_update_analysis(). Errors as of
/// analyse(); the table is then as it was.
[[nodiscard]] Status update_analysis(const Clip& clip, const AnalysisRequest& request, FrameRange changed, AnalysisTable& table);

}  // namespace marey
