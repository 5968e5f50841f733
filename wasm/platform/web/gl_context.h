#pragma once

#include "core/base/result.h"

namespace marey::app {

/// The WebGL2 context of the page's canvas. The browser may take its contents away and give it back empty at any time;
/// the context itself stays the same one.
class GlContext {
 public:
  GlContext() = default;
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Makes the context, antialiased and opaque, and makes it current. `canvas_selector` is a CSS selector.
  Status start(const char* canvas_selector);

 private:
  int handle_ = 0;
};

}  // namespace marey::app
