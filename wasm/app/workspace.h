#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/document/session.h"
#include "wasm/app/analysis.h"
#include "wasm/app/file_loading.h"
#include "wasm/app/messages.h"
#include "wasm/app/performance.h"
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
  Analysis analysis;
  Preferences preferences;
  Messages messages;
  Performance performance;
  Overlay overlay = Overlay::None;
  bool problems_wanted = false;  ///< the inspector is to turn to the problems in the next frame
  SystemPreferences system;

  /// The file that is being read, and what was open when its first frames took the place of it.
  std::unique_ptr<FileLoading> loading;
  std::optional<Session> before_loading;
  bool keeps_view = false;  ///< the clip of this serial shows what the one before it showed, with more frames

  /// Shows more of the file that is being read: a session that cannot be edited.
  void show_loaded_part(Session part);
  /// Stops reading: what was open before is back.
  void cancel_loading();
  /// What edits and downloads are about: not the part of a file that is shown while it is read.
  [[nodiscard]] const Document& whole_document() const { return before_loading ? before_loading->document : session.document; }

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
