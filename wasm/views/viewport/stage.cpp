#include "wasm/views/viewport/stage.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "wasm/views/viewport/figure_drawing.h"

namespace marey::app {
namespace {

constexpr double kTravelSizes = 2.6;  // extent of the clip in figures beyond which it wanders

constexpr double kDeepSizes = 0.25;    // how far a body on the ground may reach below it, in figures
constexpr double kEdgeOn = 0.03;       // sine of the angle between view and ground

// Radius of the grid: around a figure at rest, and wide enough for the part of the ground in view.
double fade_radius(const Stage& stage, const CameraPose& camera) {
  return std::max(5.0 * stage.size, 4.5 * camera.half_height);
}

glm::dvec3 on_ground(const Stage& stage, glm::dvec3 point) {
  point[static_cast<int>(stage.up)] = stage.ground_height;
  return point;
}

SceneLight make_light(const Stage& stage, bool dark) {
  const ViewAxes front = front_axes(stage.up);
  const double sine = std::sin(stage.light_yaw_rad);
  const double cosine = std::cos(stage.light_yaw_rad);
  const glm::dvec3 right = front.right * cosine - front.back * sine;
  const glm::dvec3 back = front.back * cosine + front.right * sine;
  SceneLight light;
  light.direction = glm::vec3(glm::normalize(-0.42 * right + 0.86 * front.up + 0.38 * back));
  light.key = dark ? glm::vec3(0.78f, 0.75f, 0.70f) : glm::vec3(0.80f, 0.77f, 0.72f);
  light.sky = dark ? glm::vec3(0.42f, 0.45f, 0.50f) : glm::vec3(0.52f, 0.55f, 0.60f);
  light.bounce = dark ? glm::vec3(0.16f, 0.17f, 0.19f) : glm::vec3(0.26f, 0.25f, 0.25f);
  light.rim = dark ? 0.28f : 0.12f;
  return light;
}

}  // namespace

double rounded_down_125(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  const double lead = value / decade * (1.0 + 1e-9);
  return decade * (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0);
}

Stage measure_stage(const Clip& clip, const FigureShape& shape) {
  Stage stage;
  const PositionRule rule = clip.settings.position_rule;
  stage.up = clip.settings.up_axis;
  stage.size = shape.size;
  stage.cell = rounded_down_125(0.18 * shape.size);
  stage.bounds = compute_clip_bounds(clip.skeleton, clip.motion, rule);
  stage.ground_height = find_ground_height(clip.skeleton, clip.motion, rule, stage.up);
  // What swings deep below the ground hangs in the air: the floor goes below it.
  const double lowest = stage.bounds.low[static_cast<int>(stage.up)];
  if (stage.ground_height - lowest > kDeepSizes * stage.size) {
    stage.ground_height = std::floor(lowest / stage.cell - 0.5) * stage.cell;
  }
  const glm::dvec3 extent = stage.bounds.size();
  stage.travels = std::max({extent.x, extent.y, extent.z}) > kTravelSizes * stage.size;
  return stage;
}

Box drawn_reach(const Stage& stage, const CameraPose& camera) {
  const glm::dvec3 center = on_ground(stage, camera.target);
  const glm::dvec3 radius(fade_radius(stage, camera));
  return {glm::min(stage.bounds.low, center - radius), glm::max(stage.bounds.high, center + radius)};
}

void add_stage(const Stage& stage, const CameraPose& camera, const Box& figure, const Theme& theme,
               const ViewOptions& options, Scene& scene) {
  const bool dark = theme.kind == ThemeKind::Dark;
  scene.background_top = scene_color(theme.viewport_top);
  scene.background_bottom = scene_color(theme.viewport_bottom);
  scene.light = make_light(stage, dark);

  SceneGround& ground = scene.ground;
  const int up = static_cast<int>(stage.up);
  ground.grid = options.show_grid;
  ground.up = stage.up;
  ground.height = static_cast<float>(stage.ground_height);
  ground.cell = static_cast<float>(stage.cell);
  ground.center = glm::vec3(on_ground(stage, camera.target));
  ground.fade_radius = static_cast<float>(fade_radius(stage, camera));
  ground.line_color = scene_color(theme.grid, 0.9f);
  ground.plane_color = dark ? glm::vec4(1.0f, 1.0f, 1.0f, 0.035f) : glm::vec4(1.0f, 1.0f, 1.0f, 0.45f);
  for (int i = 0; i < 2; ++i) ground.axis_colors[i] = scene_color(theme.axis[(up + 1 + i) % 3], 0.7f);

  scene.shadow.visible = options.show_shadow;
  scene.shadow.center = glm::vec3(figure.center());
  scene.shadow.radius = static_cast<float>(std::max(0.75 * stage.size, 0.5 * glm::length(figure.size())));
  scene.shadow.color = dark ? glm::vec4(0.0f, 0.0f, 0.0f, 0.72f) : glm::vec4(0.12f, 0.16f, 0.24f, 0.46f);
}

void add_ground_line(const Stage& stage, const CameraView& view, Scene& scene) {
  const ViewAxes front = front_axes(stage.up);
  if (!scene.ground.grid || std::abs(glm::dot(view.axes().back, front.up)) > kEdgeOn) return;
  const glm::vec3 reach(view.axes().right * static_cast<double>(scene.ground.fade_radius));
  const glm::vec4 color = scene.ground.line_color;
  const glm::vec4 clear(glm::vec3(color), 0.0f);
  const glm::vec3 center = scene.ground.center;
  scene.lines.push_back({size_of(scene.line_points), 4, 1.0f});
  scene.line_points.push_back({center - reach, clear});
  scene.line_points.push_back({center - reach * 0.25f, color});
  scene.line_points.push_back({center + reach * 0.25f, color});
  scene.line_points.push_back({center + reach, clear});
}

}  // namespace marey::app
