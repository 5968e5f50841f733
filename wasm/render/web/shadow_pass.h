#pragma once

#include "wasm/render/web/solid_pass.h"

namespace marey::app::gl {

/// Where the shadow map lies on the ground.
struct ShadowPlace {
  glm::vec3 center{0.0f};
  float half_side = 1.0f;
};

/// The figure's shadow as a small blurred picture of the ground: red what lies close under the body, green the whole.
/// Soft, without the steps and speckles of a depth map, and one texture read per pixel of ground.
class ShadowPass {
 public:
  Status start();
  /// Leaves the default framebuffer bound; the viewport is the caller's to set again.
  void draw(const Scene& scene, const SolidPass& solids);
  [[nodiscard]] GLuint map() const { return maps_[0].name(); }
  [[nodiscard]] static ShadowPlace place_of(const Scene& scene);

 private:
  struct CasterUniforms {
    GLint center = -1, axis_u = -1, axis_v = -1, scale = -1;
  };

  void set_caster_uniforms(const Program& program, const CasterUniforms& uniforms, const Scene& scene) const;
  void blur(int from, int to, const glm::vec2& step) const;

  Texture maps_[2];
  Framebuffer targets_[2];
  VertexArray no_vertices_;
  Program bone_shadow_;
  Program ball_shadow_;
  Program blur_;
  CasterUniforms bone_uniforms_;
  CasterUniforms ball_uniforms_;
  GLint blur_step_ = -1;
};

}  // namespace marey::app::gl
