#include "wasm/app/workspace.h"

#include <utility>

namespace marey::app {
namespace {

constexpr double kNoticeDuration_s = 4.0;

/// `next` shows the same figure with more frames: it goes on where `shown` is.
void follow(const Session& shown, Session& next) {
  const Motion& motion = next.document.motion();
  next.selection = shown.selection;
  next.playback = shown.playback;
  next.playback.set_clip(motion.frame_count(), motion.frame_time_s());
}

}  // namespace

void Workspace::open(Session opened) {
  ++clip_serial;
  keeps_view = before_loading.has_value();
  if (before_loading) {
    follow(session, opened);
    session = std::move(*before_loading);
    before_loading.reset();
  }
  previous.reset();
  if (session.document.is_dirty()) previous = std::move(session);
  session = std::move(opened);
}

void Workspace::show_loaded_part(Session part) {
  ++clip_serial;
  part.is_partial = true;
  keeps_view = before_loading.has_value();
  if (before_loading) {
    follow(session, part);
  } else {
    part.selection.select_only(0);
    before_loading = std::move(session);
  }
  session = std::move(part);
}

void Workspace::cancel_loading() {
  if (loading) backend.stop_loading();
  loading.reset();
  if (!before_loading) return;
  ++clip_serial;
  keeps_view = false;
  session = std::move(*before_loading);
  before_loading.reset();
}

void Workspace::go_back() {
  cancel_loading();
  ++clip_serial;
  keeps_view = false;
  std::swap(session, *previous);
}

void Workspace::notify(std::string text) {
  backend.announce(text);
  notice = std::move(text);
  notice_until_s.reset();
}

void Workspace::follow_notice() {
  if (notice.empty()) return;
  if (!notice_until_s) {
    notice_until_s = now_s + kNoticeDuration_s;
    backend.draw_after(kNoticeDuration_s + 0.05);
  }
  if (now_s > *notice_until_s) notice.clear();
}

}  // namespace marey::app
