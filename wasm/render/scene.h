#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "core/skeleton/channel.h"

namespace marey::app {

/// Colours are linear-free sRGB 0..1 with alpha, lengths file units, world axes the file's.

/// Solid bone from `from` to `to`: an octahedral-tapered or capsule-like solid, drawn lit.
struct SceneBone {
  glm::vec3 from{0.0f};
  glm::vec3 to{0.0f};
  float radius = 0.0f;
  glm::vec4 color{1.0f};
};

/// Solid ball at a joint.
struct SceneBall {
  glm::vec3 center{0.0f};
  float radius = 0.0f;
  glm::vec4 color{1.0f};
};

/// Line through world points, `width` in CSS pixels, colour per point (trails fade).
struct ScenePolyline {
  std::vector<glm::vec3> points;
  std::vector<glm::vec4> colors;
  float width = 1.5f;
};

struct SceneGround {
  bool visible = true;
  Axis up = Axis::Y;
  float height = 0.0f;       ///< along `up`
  float cell = 10.0f;        ///< side of a small cell; every tenth line is strong
  float fade_radius = 100.0f;  ///< distance from `center` at which the grid has faded
  glm::vec3 center{0.0f};
  glm::vec4 line_color{1.0f};
  glm::vec4 plane_color{1.0f};  ///< receives the shadow
};

/// All that the 3D view draws in a frame, as plain data: made by the viewport view, drawn by the renderer, looked at by
/// tests. Buffers are reused between frames.
struct Scene {
  glm::mat4 view{1.0f};
  glm::mat4 projection{1.0f};
  glm::vec3 eye{0.0f};
  glm::vec3 light_direction{0.4f, 0.8f, 0.45f};  ///< towards the light, unit length
  /// Place of the view in the window in ImGui units, origin top left.
  float x = 0.0f, y = 0.0f, width = 0.0f, height = 0.0f;
  bool shadow = true;
  glm::vec3 shadow_center{0.0f};  ///< sphere that holds what casts a shadow
  float shadow_radius = 1.0f;
  glm::vec4 background_top{0.0f};
  glm::vec4 background_bottom{0.0f};
  SceneGround ground;
  std::vector<SceneBone> bones;        ///< opaque, cast shadows
  std::vector<SceneBall> balls;
  std::vector<SceneBone> faded_bones;  ///< strobe poses: blended, no shadow
  std::vector<ScenePolyline> polylines;
};

}  // namespace marey::app
