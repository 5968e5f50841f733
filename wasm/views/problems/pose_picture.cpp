#include "wasm/views/problems/pose_picture.h"

#include <algorithm>
#include <cmath>

namespace marey::app {
namespace {

constexpr double kYaw = 0.45;  // radians from straight in front
constexpr float kWidth = 2.0f;
constexpr float kMargin = 6.0f;

/// Right and down on the screen, in file units.
glm::dvec2 seen(const glm::dvec3& world, Axis up) {
  const bool z_up = up == Axis::Z;
  const double across = world.x;
  const double ahead = z_up ? -world.y : world.z;
  return {across * std::cos(kYaw) - ahead * std::sin(kYaw), z_up ? -world.z : -world.y};
}

bool is_finite(const glm::dvec3& point) { return std::isfinite(point.x + point.y + point.z); }

/// Where the pose goes on the screen.
struct Fit {
  glm::dvec2 low{HUGE_VAL};
  glm::dvec2 high{-HUGE_VAL};
  double scale = 0.0;
  ImVec2 centre;

  [[nodiscard]] ImVec2 at(glm::dvec2 point) const {
    const glm::dvec2 from_centre = (point - 0.5 * (low + high)) * scale;
    return {centre.x + static_cast<float>(from_centre.x), centre.y + static_cast<float>(from_centre.y)};
  }
};

Fit fit_into(const WorldPose& pose, Axis up, ImVec2 min, ImVec2 max) {
  Fit fit;
  for (const glm::dvec3& position : pose.world_positions) {
    if (!is_finite(position)) continue;
    const glm::dvec2 point = seen(position, up);
    fit.low = {std::min(fit.low.x, point.x), std::min(fit.low.y, point.y)};
    fit.high = {std::max(fit.high.x, point.x), std::max(fit.high.y, point.y)};
  }
  const glm::dvec2 extent = fit.high - fit.low;
  const double room_x = max.x - min.x - 2.0f * kMargin;
  const double room_y = max.y - min.y - 2.0f * kMargin;
  const double largest = std::max(extent.x / room_x, extent.y / room_y);
  fit.scale = std::isfinite(largest) && largest > 0.0 ? 1.0 / largest : 0.0;
  fit.centre = {0.5f * (min.x + max.x), 0.5f * (min.y + max.y)};
  return fit;
}

}  // namespace

void PosePicture::compute(const Clip& clip, const ClipSettings& settings, double frame) {
  const Skeleton& skeleton = clip.skeleton;
  if (size_of(sides_) != skeleton.joint_count() || size_of(world_.world_positions) != skeleton.node_count()) {
    local_.resize(skeleton);
    world_.resize(skeleton);
    sides_ = compute_body_sides(skeleton);
  }
  if (clip.motion.frame_count() > 0) {
    compute_local_pose_between(skeleton, clip.motion, frame, settings.position_rule, local_);
  } else {
    compute_rest_pose(skeleton, local_);
  }
  compute_world_pose(skeleton, local_, world_);
}

double PosePicture::measure_height(const Clip& clip, const ClipSettings& settings, double frame) {
  compute(clip, settings, frame);
  const int axis = settings.up_axis == Axis::Z ? 2 : 1;
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const glm::dvec3& position : world_.world_positions) {
    if (!is_finite(position)) continue;
    low = std::min(low, position[axis]);
    high = std::max(high, position[axis]);
  }
  return high > low ? high - low : 0.0;
}

void PosePicture::draw(ImDrawList& draw_list, const Theme& theme, const Clip& clip, const ClipSettings& settings,
                       double frame, ImVec2 min, ImVec2 max) {
  compute(clip, settings, frame);
  const Skeleton& skeleton = clip.skeleton;
  const Fit fit = fit_into(world_, settings.up_axis, min, max);
  if (fit.scale == 0.0) return;
  for (NodeIndex index = 0; index < skeleton.node_count(); ++index) {
    const Node& node = skeleton.node(index);
    if (node.parent == kNoParent) continue;
    const glm::dvec3& from = world_.world_positions[idx(node.parent)];
    const glm::dvec3& to = world_.world_positions[idx(index)];
    if (!is_finite(from) || !is_finite(to)) continue;
    const BodySide side = sides_[idx(skeleton.node(node.parent).joint)];
    const ImU32 color = side == BodySide::Left ? theme.left : side == BodySide::Right ? theme.right : theme.middle;
    draw_list.AddLine(fit.at(seen(from, settings.up_axis)), fit.at(seen(to, settings.up_axis)), color, kWidth);
  }
}

}  // namespace marey::app
