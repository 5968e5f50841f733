#pragma once

#include "wasm/app/view_context.h"

namespace marey::app {

/// Version, what happens to files, and the licences of everything that the page ships.
class AboutView {
 public:
  /// `open` becomes false when it is to be closed.
  void draw(ViewContext& context, bool& open);

 private:
  bool licences_open_ = false;
};

/// NOTICES.md and the version, put in at build time.
[[nodiscard]] const char* notices_text();
[[nodiscard]] const char* version_text();

}  // namespace marey::app
