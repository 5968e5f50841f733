#pragma once

#include <string>

#include "core/editing/operation_target.h"
#include "wasm/app/view_context.h"

namespace marey::app {

/// What an operation of the page works on.
enum class TargetKind { Samples, Shown, Clip };

/// The narrowest of those that hold something: the selected samples, else the shown curves, else the whole clip.
[[nodiscard]] TargetKind narrowest_target(const Session& session);

/// Selected samples: their channels, over all frames from the first to the last of them. Shown curves: the visible channels
/// of the selected joints, within the range that is played. The clip: everything.
[[nodiscard]] OperationTarget make_target(const Session& session, TargetKind kind);

/// "3 channels, frames 10 to 60".
[[nodiscard]] std::string describe(const OperationTarget& target);

/// The row that asks for it. Returns true when another one was chosen.
bool draw_target_choice(ViewContext& context, TargetKind& kind);

}  // namespace marey::app
