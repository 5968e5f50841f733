#pragma once

#include "wasm/render/web/shadow_pass.h"

namespace marey::app::gl {

/// The background, and the ground with its grid and the shadow on it. Neither touches the depth buffer.
class GroundPass {
 public:
  Status start();
  void draw_background(const Scene& scene) const;
  /// `shadow_map`: picture made by ShadowPass for the same scene; read when the scene's shadow is visible.
  void draw_ground(const Scene& scene, GLuint shadow_map) const;

 private:
  VertexArray no_vertices_;
  Program background_;
  Program ground_;
  GLint top_ = -1, bottom_ = -1;
  GLint center_ = -1, axis_u_ = -1, axis_v_ = -1, fade_radius_ = -1, cell_ = -1;
  GLint shadow_place_ = -1, shadow_color_ = -1, plane_color_ = -1, line_color_ = -1;
  GLint axis_color_u_ = -1, axis_color_v_ = -1;
};

}  // namespace marey::app::gl
