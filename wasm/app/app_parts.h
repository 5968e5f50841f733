#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "wasm/app/app.h"
#include "wasm/app/commands.h"
#include "wasm/app/layout.h"
#include "wasm/app/shell.h"
#include "wasm/app/time_window.h"
#include "wasm/app/view_context.h"
#include "wasm/app/workspace.h"

namespace marey::app {

/// What an App is made of. Commands and views refer to members, so it stays where it was made.
struct AppParts {
  AppParts(Backend& backend, const FontFiles& files) : workspace(backend), fonts(add_fonts(files)) {}

  /// For the views of one frame.
  [[nodiscard]] ViewContext make_context();

  Workspace workspace;
  CommandRegistry commands;
  Fonts fonts;
  Theme theme;
  TimeWindow time_window;
  UiItems items;
  WidgetState widgets;
  Hover hover;
  Hover next_hover;
  std::string status;
  std::string refusal;
  Scene scene;
  Shell shell;
  std::uint64_t shown_clip_serial = 0;  ///< the clip that the views have been told of

  std::optional<bool> touched;  ///< the last press came from a finger; nothing before the first
  bool redraw = false;
  int settling_frames = 0;  ///< drawn after input without being asked, so that sizes and hovers come to rest
  double last_frame_s = -1.0;
  bool last_frame_failed = false;
  Preferences known_preferences;  ///< as they were when last stored
  std::string stored_preferences;
  std::string mouse_cursor;
  std::string announced_name;
  bool announced_dirty = false;
};

}  // namespace marey::app
