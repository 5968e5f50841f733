#pragma once

#include "core/document/session.h"
#include "wasm/app/commands.h"
#include "wasm/views/viewport/viewport_state.h"

namespace marey::app {

/// Adds the commands that move the camera: view.frame_all, view.frame_selection, view.front, view.back, view.side,
/// view.side_opposite, view.top, view.bottom, view.orbit, view.zoom_in and view.zoom_out. All arguments outlive the
/// registry. Arguments of the commands: docs/page-api.md.
void add_viewport_commands(CommandRegistry& registry, const Session& session, ViewportState& state);

}  // namespace marey::app
