#include "wasm/platform/web/gl_context.h"

#include <emscripten/html5.h>

namespace marey::app {

GlContext::~GlContext() {
  if (handle_ > 0) emscripten_webgl_destroy_context(handle_);
}

Status GlContext::start(const char* canvas_selector) {
  EmscriptenWebGLContextAttributes attributes;
  emscripten_webgl_init_context_attributes(&attributes);
  attributes.majorVersion = 2;
  attributes.minorVersion = 0;
  attributes.alpha = false;
  attributes.depth = true;
  attributes.stencil = false;
  attributes.antialias = true;
  attributes.powerPreference = EM_WEBGL_POWER_PREFERENCE_DEFAULT;
  handle_ = emscripten_webgl_create_context(canvas_selector, &attributes);
  if (handle_ <= 0 || emscripten_webgl_make_context_current(handle_) != EMSCRIPTEN_RESULT_SUCCESS) {
    return Error{DiagnosticCode::InvalidArgument, {}, "The browser gives no WebGL 2 context.", "", ""};
  }
  return {};
}

}  // namespace marey::app
