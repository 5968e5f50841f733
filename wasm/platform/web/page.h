#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "wasm/app/app.h"
#include "wasm/platform/backend.h"
#include "wasm/platform/web/gl_context.h"
#include "wasm/platform/web/input.h"
#include "wasm/render/scene_renderer.h"

struct ImGuiContext;

namespace marey::app {

/// The program in a browser's page: owns the ImGui context, the WebGL context and the App, and draws a frame when the
/// page asks for one.
class Page {
 public:
  Page();
  ~Page();
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  /// Makes the WebGL context and the App. Precondition: not started.
  Status start(FontFiles fonts);

  /// The rest needs a started page.
  [[nodiscard]] App& app() { return *app_; }
  [[nodiscard]] Input& input() { return input_; }

  void resize(const WindowSize& window) { window_ = window; }
  /// Text that another program has put on the clipboard, for pasting into a text field.
  void set_clipboard_text(std::string text) { clipboard_text_ = std::move(text); }

  /// Runs and draws one frame. Returns true when a further one is wanted without new input.
  bool frame(double now_ms);

  /// The browser has got a font that letters were waiting for: they are drawn again.
  void forget_letters();

  /// The browser has taken the contents of the WebGL context away: forgets them. No frame until restore_context().
  void lose_context();
  /// The browser has given the context back, empty: everything is uploaded again.
  Status restore_context();

 private:
  void connect_imgui();
  void draw();
  void note_cost(double begin_ms);

  Backend backend_;
  GlContext gl_;
  SceneRenderer scene_renderer_;
  ImGuiContext* imgui_ = nullptr;
  Input input_;
  WindowSize window_;
  std::string clipboard_text_;
  std::unique_ptr<App> app_;
};

}  // namespace marey::app
