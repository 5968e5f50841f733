#pragma once

#include <cstdint>
#include <string>

#include "core/document/session.h"
#include "wasm/app/analysis.h"
#include "wasm/app/commands.h"
#include "wasm/app/fonts.h"
#include "wasm/app/theme.h"
#include "wasm/app/time_window.h"
#include "wasm/app/ui_items.h"
#include "wasm/app/view_options.h"
#include "wasm/app/widget_state.h"
#include "wasm/platform/backend.h"

namespace marey::app {

/// What a panel needs to draw itself. Nobody keeps it beyond the call.
struct ViewContext {
  Session& session;
  std::uint64_t clip_serial = 0;  ///< grows with each opened file; a cache is valid for (clip_serial, revision)
  CommandRegistry& commands;
  Analysis& analysis;
  ViewOptions& options;
  TimeWindow& time_window;  ///< shared by ruler and curves
  const Theme& theme;
  const Fonts& fonts;
  UiItems& items;
  const Hover& hover;  ///< of the last frame
  Hover& next_hover;   ///< what this frame's views find under the pointer
  std::string& status; ///< one line that says what a drag does, or what just happened; shown in the viewport's corner
  std::string& refusal; ///< why something was not done; said for a few seconds
  double now_s = 0.0;
  bool& redraw;        ///< set to ask for a further frame (animation running)
  WidgetState& widgets;  ///< memory of the controls in widgets.h; new_gesture() serves every view
  const SystemPreferences& system;
};

}  // namespace marey::app
