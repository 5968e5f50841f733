#pragma once

#include <memory>

#include "core/base/result.h"
#include "wasm/render/scene.h"

namespace marey::app {

/// Draws a Scene into the current WebGL2 context's default framebuffer.
class SceneRenderer {
 public:
  SceneRenderer();
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;

  /// Compiles the programs and makes the buffers. Call with the context current; after a context was lost, call
  /// release() and start() again. The error says which program failed and the driver's reason.
  Status start();

  /// Clears the framebuffer (in pixels) and draws the scene into its place. `pixels_per_unit`: framebuffer pixels per
  /// ImGui unit. Leaves the state that ImGui's backend expects: no framebuffer, program or vertex array bound, no
  /// scissor, depth or cull test. Does nothing but clear before start().
  void draw(const Scene& scene, int framebuffer_width, int framebuffer_height, float pixels_per_unit);

  /// Draw calls and vertices since it was last asked.
  struct Count {
    int calls = 0;
    int vertices = 0;
  };
  [[nodiscard]] Count take_count();

  /// Gives everything back to the context. Does nothing when not started.
  void release();

 private:
  struct Passes;
  std::unique_ptr<Passes> passes_;
};

}  // namespace marey::app
