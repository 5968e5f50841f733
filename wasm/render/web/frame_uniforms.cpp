#include "wasm/render/web/frame_uniforms.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/matrix.hpp>

namespace marey::app::gl {
namespace {

glm::vec3 to_linear(const glm::vec4& srgb) { return glm::pow(glm::vec3(srgb), glm::vec3(2.2f)); }

// Depth under the ground at which the haze is thickest, in cells of the grid.
constexpr float kHazeDepthCells = 0.5f;

}  // namespace

glm::vec3 unit_vector(Axis axis) {
  glm::vec3 unit(0.0f);
  unit[static_cast<int>(axis)] = 1.0f;
  return unit;
}

glm::vec3 ground_axis_u(Axis up) { return unit_vector(static_cast<Axis>((static_cast<int>(up) + 1) % 3)); }

glm::vec3 ground_axis_v(Axis up) { return unit_vector(static_cast<Axis>((static_cast<int>(up) + 2) % 3)); }

FrameUniforms make_frame_uniforms(const Scene& scene, const PixelRect& view, float pixels_per_unit) {
  const glm::mat4 view_to_world = glm::inverse(scene.view);
  const glm::vec3 haze = 0.5f * (to_linear(scene.background_top) + to_linear(scene.background_bottom));
  FrameUniforms frame;
  frame.world_to_clip = scene.projection * scene.view;
  frame.eye = glm::vec4(scene.eye, scene.orthographic ? 1.0f : 0.0f);
  frame.view_direction = -view_to_world[2];
  frame.light_direction = glm::vec4(scene.light.direction, scene.light.rim);
  frame.key = glm::vec4(scene.light.key, 0.0f);
  frame.sky = glm::vec4(scene.light.sky, 0.0f);
  frame.bounce = glm::vec4(scene.light.bounce, 0.0f);
  frame.up = glm::vec4(unit_vector(scene.ground.up), scene.ground.height);
  frame.haze = glm::vec4(haze, 1.0f / (kHazeDepthCells * glm::max(scene.ground.cell, 1e-6f)));
  frame.viewport = glm::vec4(view.width, view.height, pixels_per_unit, 0.0f);
  return frame;
}

}  // namespace marey::app::gl
