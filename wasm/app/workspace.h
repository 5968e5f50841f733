#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/document/session.h"
#include "wasm/app/messages.h"
#include "wasm/app/preferences.h"
#include "wasm/platform/backend.h"

namespace marey::app {

/// Windows above the panels; at most one is open.
enum class Overlay { None, Palette, Shortcuts, About, Welcome, SaveAs };

/// What the program has open and how it is shown. Commands change it, views show it.
struct Workspace {
  explicit Workspace(Backend& used_backend) : backend(used_backend) {}

  Backend& backend;
  Session session;
  /// What was open before, with changes that were not downloaded, so that opening a file loses nothing.
  std::optional<Session> previous;
  std::uint64_t clip_serial = 0;  ///< grows with each change of what is open
  Preferences preferences;
  Messages messages;
  Overlay overlay = Overlay::None;
  bool problems_wanted = false;  ///< the inspector is to turn to the problems in the next frame
  SystemPreferences system;

  /// Opens a session in place of the present one, which is kept as `previous` when it has changes to lose.
  void open(Session opened);
  /// Exchanges `session` and `previous`. Precondition: there is a previous one.
  void go_back();

  /// Says what just happened, to the eye and to assistive technology, for a few seconds.
  void notify(std::string text);
  /// Shows and ends the notice; in every frame.
  void follow_notice();

  std::string notice;
  std::optional<double> notice_until_s;  ///< nothing before the frame that first shows it
  double now_s = 0.0;

  [[nodiscard]] bool has_clip() const { return session.document.skeleton().joint_count() > 0; }
  [[nodiscard]] bool has_frames() const { return session.document.motion().frame_count() > 0; }
};

}  // namespace marey::app
