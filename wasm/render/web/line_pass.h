#pragma once

#include <vector>

#include "wasm/render/scene.h"
#include "wasm/render/web/gl_objects.h"

namespace marey::app::gl {

/// Lines of constant width on the screen, behind what the depth buffer holds.
class LinePass {
 public:
  Status start();
  void draw(const Scene& scene, float pixels_per_unit);

 private:
  void upload(const Scene& scene);

  Program program_;
  GLint half_width_ = -1;
  VertexArray array_;
  StreamBuffer points_;
  std::vector<SceneLinePoint> padded_points_;  // kept between frames so that drawing does not allocate
};

}  // namespace marey::app::gl
