#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "wasm/render/scene.h"

namespace marey::app::gl {

/// What every program reads, in the layout of the GLSL block "Frame" (std140).
struct FrameUniforms {
  glm::mat4 world_to_clip{1.0f};
  glm::vec4 eye{0.0f};
  glm::vec4 view_direction{0.0f};
  glm::vec4 light_direction{0.0f};
  glm::vec4 key{0.0f};
  glm::vec4 sky{0.0f};
  glm::vec4 bounce{0.0f};
  glm::vec4 up{0.0f};
  glm::vec4 haze{0.0f};
  glm::vec4 viewport{0.0f};
};

/// Place of the view in the framebuffer, in pixels, origin bottom left.
struct PixelRect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

[[nodiscard]] FrameUniforms make_frame_uniforms(const Scene& scene, const PixelRect& view, float pixels_per_unit);

[[nodiscard]] glm::vec3 unit_vector(Axis axis);
/// The ground's two directions: the axes after `up` in the cycle X Y Z.
[[nodiscard]] glm::vec3 ground_axis_u(Axis up);
[[nodiscard]] glm::vec3 ground_axis_v(Axis up);

}  // namespace marey::app::gl
