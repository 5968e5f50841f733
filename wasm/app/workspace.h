#pragma once

#include <string>

#include "core/document/session.h"
#include "wasm/app/messages.h"
#include "wasm/app/preferences.h"
#include "wasm/platform/backend.h"

namespace marey::app {

/// Windows above the panels; at most one is open.
enum class Overlay { None, Palette, Shortcuts, About, Welcome };

/// What the program has open and how it is shown. Commands change it, views show it.
struct Workspace {
  explicit Workspace(Backend& used_backend) : backend(used_backend) {}

  Backend& backend;
  Session session;
  Preferences preferences;
  Messages messages;
  Overlay overlay = Overlay::None;
  bool problems_wanted = false;  ///< the inspector is to turn to the problems in the next frame
  SystemPreferences system;

  /// Says what just happened, to the eye and to assistive technology: until something else is said, at least for a
  /// few seconds. An idle page is not woken to take it away.
  void notify(std::string text);
  std::string notice;
  double notice_until_s = 0.0;
  double now_s = 0.0;

  [[nodiscard]] bool has_clip() const { return session.document.skeleton().joint_count() > 0; }
  [[nodiscard]] bool has_frames() const { return session.document.motion().frame_count() > 0; }
};

}  // namespace marey::app
