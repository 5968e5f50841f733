#include "wasm/views/viewport/figure_drawing.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace marey::app {
namespace {

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x + v.y + v.z); }

// The bone as the pose holds it; false when it has no length or a sample is no number.
bool place_bone(const FigureBone& bone, const WorldPose& pose, SceneBone& placed) {
  const glm::dvec3& from = pose.world_positions[idx(bone.from)];
  const glm::dvec3& to = pose.world_positions[idx(bone.to)];
  const double length = glm::distance(from, to);
  if (!(length > 1e-3 * bone.radius) || !std::isfinite(length)) return false;
  const glm::dvec3 along = (to - from) / length;
  glm::dvec3 side = pose.world_rotations[idx(bone.joint)] * bone.local_side;
  side -= along * glm::dot(side, along);
  const double side_length = glm::length(side);
  if (!(side_length > 1e-6)) {
    // A free joint has come to lie along the old side.
    side = glm::cross(along, std::abs(along.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1));
    placed.side = glm::vec3(glm::normalize(side));
  } else {
    placed.side = glm::vec3(side / side_length);
  }
  placed.from = glm::vec3(from);
  placed.to = glm::vec3(to);
  placed.radius = static_cast<float>(bone.radius);
  return true;
}

glm::dvec3 ball_center(const FigureBall& ball, const WorldPose& pose) {
  const glm::dvec3& here = pose.world_positions[idx(ball.node)];
  if (ball.share_to_parent <= 0.0) return here;
  return glm::mix(here, pose.world_positions[idx(ball.parent)], ball.share_to_parent);
}

struct Palette {
  glm::vec4 sides[3];
  glm::vec4 selection;
};

Palette make_palette(const Theme& theme) {
  // The light theme's colours are made for text; a solid in them would be too dark.
  const float lift = theme.kind == ThemeKind::Dark ? 0.0f : 0.15f;
  Palette palette;
  const ImU32 sides[] = {theme.middle, theme.left, theme.right};
  for (int i = 0; i < 3; ++i) palette.sides[i] = glm::mix(scene_color(sides[i]), glm::vec4(1.0f), lift);
  palette.selection = glm::mix(scene_color(theme.selection), glm::vec4(1.0f), lift);
  return palette;
}

constexpr float kHoverLight = 0.4f;
constexpr float kBallShade = 0.78f;
constexpr float kGhostShare = 0.35f;
constexpr float kTetherWidth = 1.0f;
constexpr float kTetherAlpha = 0.6f;

}  // namespace

glm::vec4 scene_color(ImU32 color, float alpha) {
  const ImVec4 parts = ImGui::ColorConvertU32ToFloat4(color);
  return {parts.x, parts.y, parts.z, parts.w * alpha};
}

glm::vec4 side_color(const Theme& theme, BodySide side) { return make_palette(theme).sides[static_cast<int>(side)]; }

void add_figure(const FigureShape& shape, const WorldPose& pose, const Selection& selection, JointIndex hovered,
                const Theme& theme, Scene& scene) {
  const Palette palette = make_palette(theme);
  SceneBone placed;
  for (const FigureBone& bone : shape.bones) {
    if (!place_bone(bone, pose, placed)) continue;
    placed.color = palette.sides[static_cast<int>(bone.side)];
    if (bone.joint == hovered) placed.color = glm::mix(placed.color, glm::vec4(1.0f), kHoverLight);
    scene.bones.push_back(placed);
    if (!selection.contains(bone.joint)) continue;
    placed.color = palette.selection;
    scene.outlined_bones.push_back(placed);
  }
  for (const FigureBall& ball : shape.balls) {
    const glm::dvec3 center = ball_center(ball, pose);
    if (!is_finite(center)) continue;
    const bool selected = !ball.is_tip && selection.contains(ball.joint);
    const glm::vec4& side = palette.sides[static_cast<int>(ball.side)];
    const float shade = ball.is_tip ? 1.0f : kBallShade;
    glm::vec4 color = selected ? palette.selection : glm::vec4(glm::vec3(side) * shade, 1.0f);
    if (ball.joint == hovered) color = glm::mix(color, glm::vec4(1.0f), kHoverLight);
    const auto radius = static_cast<float>(ball.radius * (selected ? 1.2 : 1.0));
    scene.balls.push_back({glm::vec3(center), radius, color});
    if (selected) scene.outlined_balls.push_back({glm::vec3(center), radius, palette.selection});
  }
}

void add_tethers(const FigureShape& shape, const WorldPose& pose, const Theme& theme, Scene& scene) {
  for (const FigureBone& tether : shape.tethers) {
    const glm::dvec3& from = pose.world_positions[idx(tether.from)];
    const glm::dvec3& to = pose.world_positions[idx(tether.to)];
    if (!is_finite(from) || !is_finite(to)) continue;
    scene.lines.push_back({size_of(scene.line_points), 2, kTetherWidth});
    scene.line_points.push_back({glm::vec3(from), scene_color(theme.ghost, kTetherAlpha)});
    scene.line_points.push_back({glm::vec3(to), scene_color(theme.ghost, kTetherAlpha)});
  }
}

void add_faded_figure(const FigureShape& shape, const WorldPose& pose, const Theme& theme, float alpha, Scene& scene) {
  const Palette palette = make_palette(theme);
  const glm::vec4 ghost = scene_color(theme.ghost);
  SceneBone placed;
  for (const FigureBone& bone : shape.bones) {
    if (!place_bone(bone, pose, placed)) continue;
    placed.color = glm::mix(palette.sides[static_cast<int>(bone.side)], ghost, kGhostShare);
    placed.color.a = alpha;
    scene.faded_bones.push_back(placed);
  }
  for (const FigureBall& ball : shape.balls) {
    const glm::dvec3 center = ball_center(ball, pose);
    if (!ball.is_head || !is_finite(center)) continue;
    glm::vec4 color = glm::mix(palette.sides[static_cast<int>(ball.side)], ghost, kGhostShare);
    color.a = alpha;
    scene.faded_balls.push_back({glm::vec3(center), static_cast<float>(ball.radius), color});
  }
}

void collect_solids(const FigureShape& shape, const WorldPose& pose, std::vector<PickSolid>& solids) {
  solids.clear();
  for (const FigureBone& bone : shape.bones) {
    solids.push_back({pose.world_positions[idx(bone.from)], pose.world_positions[idx(bone.to)], 0.7 * bone.radius, bone.joint});
  }
  for (const FigureBall& ball : shape.balls) {
    const glm::dvec3 center = ball_center(ball, pose);
    solids.push_back({center, center, ball.radius, ball.joint});
  }
}

}  // namespace marey::app
