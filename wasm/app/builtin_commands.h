#pragma once

#include <string>
#include <string_view>

#include "wasm/app/commands.h"
#include "wasm/app/workspace.h"

namespace marey::app {

/// The commands of the shell; those of a view are registered by the view. `workspace` outlives the registry.
/// Arguments are documented in docs/page-api.md.
void add_file_commands(CommandRegistry& registry, Workspace& workspace);
void add_save_commands(CommandRegistry& registry, Workspace& workspace);
void add_edit_commands(CommandRegistry& registry, Workspace& workspace);
void add_operation_commands(CommandRegistry& registry, Workspace& workspace);
void add_play_commands(CommandRegistry& registry, Workspace& workspace);
void add_view_commands(CommandRegistry& registry, Workspace& workspace);
void add_clip_commands(CommandRegistry& registry, Workspace& workspace);
void add_frame_commands(CommandRegistry& registry, Workspace& workspace);
void add_help_commands(CommandRegistry& registry, Workspace& workspace);

/// Registers a command that turns `value` over, or sets it by {"on": true} and {"on": false}.
void add_switch(CommandRegistry& registry, Command command, bool& value);

/// "walk.bvh" for "walk.bvh", "walk.BVH", "walk.txt" and "walk"; "clip.bvh" for an empty name.
[[nodiscard]] std::string download_name(std::string_view file_name);

/// Whether the first frame of the opened file has been left out.
[[nodiscard]] bool is_first_frame_left_out(const Document& document);

/// Why a command that needs an open clip cannot run; "" when it can.
[[nodiscard]] Reason needs_clip(const Workspace& workspace);
/// The same for one that changes or saves it: not while its file is still being read.
[[nodiscard]] Reason needs_whole_clip(const Workspace& workspace);
/// The same for one that needs frames.
[[nodiscard]] Reason needs_frames(const Workspace& workspace);

}  // namespace marey::app
