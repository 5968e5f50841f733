#include "wasm/app/workspace.h"

#include <utility>

namespace marey::app {
namespace {
constexpr double kNoticeDuration_s = 4.0;
}

void Workspace::notify(std::string text) {
  backend.announce(text);
  notice = std::move(text);
  notice_until_s = now_s + kNoticeDuration_s;
}

}  // namespace marey::app
