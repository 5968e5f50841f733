#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "core/skeleton/channel.h"

namespace marey::app {

/// Colours are sRGB 0..1 with straight alpha, lengths file units, world axes the file's.

/// Solid bone: round ends, thickest a fifth of the way along, with a slightly square section that shows its roll.
/// The two points are apart.
struct SceneBone {
  glm::vec3 from{0.0f};
  float radius = 0.0f;  ///< where it is thickest
  glm::vec3 to{0.0f};
  glm::vec3 side{1.0f, 0.0f, 0.0f};  ///< unit, at right angles to the bone; turns with the joint
  glm::vec4 color{1.0f};
};

/// Solid ball at a joint.
struct SceneBall {
  glm::vec3 center{0.0f};
  float radius = 0.0f;
  glm::vec4 color{1.0f};
};

/// Ellipsoid, blended once per pixel over the figure; what lies in it shows through.
struct SceneEllipsoid {
  glm::vec3 center{0.0f};
  glm::vec3 axes[3] = {glm::vec3(0.0f), glm::vec3(0.0f), glm::vec3(0.0f)};  ///< half axes, at right angles, right-handed, none 0
  glm::vec4 color{1.0f};
};

struct SceneLinePoint {
  glm::vec3 position{0.0f};
  glm::vec4 color{1.0f};
};

/// Line through Scene::line_points [first, first + count), `width` in ImGui units, colour from point to point.
struct SceneLine {
  int first = 0;
  int count = 0;
  float width = 1.5f;
};

/// The plane that the figure stands on, with its grid. The grid's two directions are the world axes after `up` in the
/// cycle X Y Z, so with Y up they are Z and X.
struct SceneGround {
  bool grid = true;
  Axis up = Axis::Y;
  float height = 0.0f;       ///< along `up`
  float cell = 10.0f;        ///< side of a small cell; every tenth line is strong
  glm::vec3 center{0.0f};    ///< where the grid is strongest
  float fade_radius = 100.0f;  ///< distance from `center` at which it has faded
  glm::vec4 line_color{1.0f};
  glm::vec4 plane_color{0.0f};  ///< a disc of floor under the figure; alpha 0 for none
  glm::vec4 axis_colors[2] = {glm::vec4(1.0f), glm::vec4(1.0f)};  ///< of the lines through the origin, in cycle order
};

/// Soft shadow on the ground of what stands in a sphere.
struct SceneShadow {
  bool visible = true;
  glm::vec3 center{0.0f};
  float radius = 1.0f;
  glm::vec4 color{0.0f, 0.0f, 0.0f, 0.5f};
};

struct SceneLight {
  glm::vec3 direction{0.4f, 0.8f, 0.45f};  ///< towards the light, unit length
  glm::vec3 key{1.0f};     ///< linear, of the directed light
  glm::vec3 sky{0.5f};     ///< linear, ambient from above
  glm::vec3 bounce{0.3f};  ///< linear, ambient from below
  float rim = 0.3f;        ///< strength of the bright edge
};

/// All that the 3D view draws in a frame, as plain data: made by the viewport view, drawn by the renderer, looked at by
/// tests. Buffers are reused between frames.
struct Scene {
  glm::mat4 view{1.0f};
  glm::mat4 projection{1.0f};
  glm::vec3 eye{0.0f};             ///< where the camera is; far behind for an orthographic view
  bool orthographic = false;
  /// Place of the view in the window in ImGui units, origin top left. Nothing is drawn when it is empty.
  float x = 0.0f, y = 0.0f, width = 0.0f, height = 0.0f;
  glm::vec4 background_top{0.0f};
  glm::vec4 background_bottom{0.0f};
  SceneLight light;
  SceneGround ground;
  SceneShadow shadow;
  std::vector<SceneBone> bones;  ///< opaque, cast shadows
  std::vector<SceneBall> balls;
  float outline_width = 2.0f;             ///< ImGui units
  std::vector<SceneBone> outlined_bones;  ///< drawn as an edge in their colour around the same solid in `bones`
  std::vector<SceneBall> outlined_balls;
  std::vector<SceneBone> faded_bones;  ///< strobe poses: blended once per pixel, behind `bones`, no shadow
  std::vector<SceneBall> faded_balls;
  std::uint64_t faded_revision = 0;  ///< changes with the faded solids; equal: the renderer may keep its copy
  std::vector<SceneEllipsoid> ellipsoids;  ///< segments of the body; no shadow
  std::vector<SceneLinePoint> line_points;
  std::vector<SceneLine> lines;
};

}  // namespace marey::app
