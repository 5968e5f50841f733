#include "wasm/views/viewport/camera_control.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "core/kinematics/forward_kinematics.h"

namespace marey::app {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kOpeningPitch_rad = 0.17;
constexpr double kAside_rad = 0.55;        // of a figure's front
constexpr double kAsidePlane_rad = 0.22;   // of a motion in a plane
constexpr double kPlanar = 0.12;           // depth of such a motion by its extent
constexpr double kMargin = 1.2;
constexpr double kLeastHalfHeight = 0.16;  // statures
constexpr int kFramedSamples = 32;
constexpr double kFollowWindow_s = 0.6;    // each way
constexpr int kMostFollowFrames = 128;     // each way

// From right to left of the body at the pose; 0 for a figure without sides.
glm::dvec3 leftwards(const Skeleton& skeleton, const FigureShape& shape, const WorldPose& pose) {
  glm::dvec3 sums[3]{};
  double counts[3]{};
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const auto side = static_cast<std::size_t>(shape.sides[idx(joint)]);
    sums[side] += pose.world_positions[idx(skeleton.node_of(joint))];
    counts[side] += 1.0;
  }
  constexpr auto kLeft = static_cast<std::size_t>(BodySide::Left);
  constexpr auto kRight = static_cast<std::size_t>(BodySide::Right);
  if (counts[kLeft] == 0.0 || counts[kRight] == 0.0) return glm::dvec3(0.0);
  return sums[kLeft] / counts[kLeft] - sums[kRight] / counts[kRight];
}

// Where the nodes are over the whole clip, at evenly spread frames.
std::vector<glm::dvec3> sample_positions(const Clip& clip) {
  std::vector<glm::dvec3> positions;
  const int frames = std::max(clip.motion.frame_count(), 1);
  const int samples = std::min(frames, kFramedSamples);
  LocalPose local;
  WorldPose pose;
  for (int i = 0; i < samples; ++i) {
    compute_clip_pose(clip, samples > 1 ? static_cast<double>(i) * (frames - 1) / (samples - 1) : 0.0, local, pose);
    positions.insert(positions.end(), pose.world_positions.begin(), pose.world_positions.end());
  }
  std::erase_if(positions, [](const glm::dvec3& p) { return !std::isfinite(p.x + p.y + p.z); });
  return positions;
}

std::vector<glm::dvec3> selected_positions(const Session& session, const WorldPose& pose) {
  std::vector<glm::dvec3> positions;
  const auto nodes = session.document.skeleton().nodes();
  for (NodeIndex node = 0; node < size_of(nodes); ++node) {
    const NodeIndex parent = nodes[idx(node)].parent;
    const bool own = !nodes[idx(node)].is_end_site && session.selection.contains(nodes[idx(node)].joint);
    const bool child = parent != kNoParent && session.selection.contains(nodes[idx(parent)].joint);
    if (own || child) positions.push_back(pose.world_positions[idx(node)]);
  }
  return positions;
}

CameraPose framed_pose(const Session& session, const FigureCache& figure, const CameraPose& direction, double aspect,
                       bool whole_motion) {
  const Clip& clip = session.document.clip();
  const double least = kLeastHalfHeight * figure.stage().size;
  if (whole_motion) return framed(direction, figure.stage().up, aspect, sample_positions(clip), kMargin, least);
  return framed(direction, figure.stage().up, aspect, figure.pose().world_positions, kMargin, least);
}

void open_view(ViewContext& context, ViewportState& state, double aspect) {
  const Stage& stage = state.figure.stage();
  const double extent = std::max(glm::length(stage.bounds.size()), stage.size);
  state.camera.set_up(stage.up);
  state.camera.set_zoom_range(0.01 * stage.size, 20.0 * extent);
  state.camera.jump_to(opening_pose(context.session, state.figure, aspect, context.options.orthographic ? 0.0 : 1.0));
  state.figure.light_from(state.camera.pose().yaw_rad);
  context.options.follow_root = stage.travels;
  state.followed.reset();
  state.request = {};
}

void follow_request(ViewContext& context, ViewportState& state, const glm::dvec2& size) {
  CameraRequest request = std::exchange(state.request, {});
  CameraPose goal = state.camera.goal();
  const CameraPose before = goal;
  goal.yaw_rad = request.yaw_rad.value_or(goal.yaw_rad);
  goal.pitch_rad = request.pitch_rad.value_or(goal.pitch_rad);
  goal.half_height *= request.zoom;
  goal.perspective = context.options.orthographic ? 0.0 : 1.0;
  const double aspect = size.x / size.y;
  if (request.framing == CameraRequest::Framing::All) {
    state.figure.measure_bounds(context.session.document.clip());
    goal = framed_pose(context.session, state.figure, goal, aspect, !context.options.follow_root);
  } else if (request.framing == CameraRequest::Framing::Selection) {
    const auto selected = selected_positions(context.session, state.figure.pose());
    const std::span<const glm::dvec3> points = selected.empty() ? state.figure.pose().world_positions : selected;
    const double least = kLeastHalfHeight * state.figure.stage().size;
    goal = framed(goal, state.figure.stage().up, aspect, points, kMargin, least);
  }
  if (goal == before) return;
  state.camera.move_to(goal, context.now_s, !context.system.reduced_motion);
}

void follow_figure(ViewContext& context, ViewportState& state) {
  if (!context.options.follow_root) {
    state.followed.reset();
    return;
  }
  const glm::dvec3 here = followed_point(context.session, state.figure.stage());
  if (state.followed && std::isfinite(here.x + here.y + here.z)) state.camera.shift(here - *state.followed);
  state.followed = here;
}

}  // namespace

CameraPose opening_direction(const Clip& clip, const FigureShape& shape, const Stage& stage,
                             const WorldPose& first_pose) {
  const ViewAxes front = front_axes(stage.up);
  CameraPose pose;
  pose.pitch_rad = kOpeningPitch_rad;
  const glm::dvec3 extent = stage.bounds.size();
  const double across = std::abs(glm::dot(extent, front.right));
  const double along = std::abs(glm::dot(extent, front.back));
  const double largest = std::max({extent.x, extent.y, extent.z});
  if (along < kPlanar * largest || across < kPlanar * largest) {
    pose.yaw_rad = across < along ? 0.5 * kPi - kAsidePlane_rad : kAsidePlane_rad;
    return pose;
  }
  const glm::dvec3 forwards = glm::cross(leftwards(clip.skeleton, shape, first_pose), front.up);
  if (glm::length(forwards) > 0.02 * stage.size) {
    pose.yaw_rad = std::atan2(glm::dot(forwards, front.right), glm::dot(forwards, front.back));
  }
  pose.yaw_rad = std::remainder(pose.yaw_rad - kAside_rad, 2.0 * kPi);
  return pose;
}

CameraPose opening_pose(const Session& session, const FigureCache& figure, double aspect, double perspective) {
  const Clip& clip = session.document.clip();
  CameraPose pose = opening_direction(clip, figure.shape(), figure.stage(), figure.pose());
  pose.perspective = perspective;
  return framed_pose(session, figure, pose, aspect, !figure.stage().travels);
}

glm::dvec3 followed_point(const Session& session, const Stage& stage) {
  const Clip& clip = session.document.clip();
  if (clip.motion.frame_count() == 0) return glm::dvec3(0.0);
  const double position = session.playback.position();
  // Triangular weights of a whole number of frames keep an even motion even, also between frames.
  const double wanted = std::clamp(std::round(kFollowWindow_s / clip.motion.frame_time_s()), 1.0, double{kMostFollowFrames});
  const int reach = std::min(static_cast<int>(wanted), clip.motion.frame_count() - 1);
  const int earliest = static_cast<int>(std::floor(position)) - reach;
  const int latest = static_cast<int>(std::ceil(position)) + reach;
  const int first = std::max(earliest, 0);
  const int last = std::min(latest, clip.motion.frame_count() - 1);
  const auto root_at = [&](int frame) {
    return joint_translation(clip.skeleton, clip.motion, 0, std::clamp(frame, first, last), clip.settings.position_rule);
  };
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  for (int frame = earliest; frame <= latest; ++frame) {
    const double weight = 1.0 - std::abs(frame - position) / (reach + 1);
    // Beyond the ends the motion is mirrored, so that a walk goes on at its speed.
    const int inside = std::clamp(frame, 0, clip.motion.frame_count() - 1);
    sum += weight * (frame == inside ? root_at(frame) : 2.0 * root_at(inside) - root_at(2 * inside - frame));
    weights += weight;
  }
  glm::dvec3 point = sum / weights;
  point[static_cast<int>(stage.up)] = stage.ground_height;
  return point;
}

void update_camera(ViewContext& context, ViewportState& state, const glm::dvec2& size) {
  const bool another_figure = state.seen_figure_serial != state.figure.figure_serial();
  const bool another_up = state.camera.up() != state.figure.stage().up;
  state.seen_figure_serial = state.figure.figure_serial();
  if (state.wants_opening_view || (another_figure && another_up)) open_view(context, state, size.x / size.y);
  state.wants_opening_view = false;
  follow_request(context, state, size);
  follow_figure(context, state);
  if (state.camera.advance(context.now_s)) context.redraw = true;
  Box reach = drawn_reach(state.figure.stage(), state.camera.pose());
  reach.low = glm::min(reach.low, state.figure.pose_box().low);
  reach.high = glm::max(reach.high, state.figure.pose_box().high);
  state.view = CameraView(state.camera.pose(), state.camera.up(), size, reach);
}

}  // namespace marey::app
