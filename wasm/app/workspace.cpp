#include "wasm/app/workspace.h"

#include <utility>

namespace marey::app {
namespace {
constexpr double kNoticeDuration_s = 4.0;
}

void Workspace::open(Session opened) {
  ++clip_serial;
  previous.reset();
  if (session.document.is_dirty()) previous = std::move(session);
  session = std::move(opened);
}

void Workspace::go_back() {
  ++clip_serial;
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
