#include "wasm/views/viewport/trails.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/stable_order.h"
#include "core/kinematics/forward_kinematics.h"
#include "wasm/views/viewport/figure_drawing.h"

namespace marey::app {
namespace {

constexpr int kMostEnds = 5;
constexpr double kEndsApart = 0.3;  // statures
constexpr double kWhole_s = 8.0;    // ranges up to this long are shown whole
constexpr double kWindow_s = 3.0;   // each way
constexpr int kStretch = 512;       // paths are computed in multiples of this many frames
constexpr float kWidth = 2.0f;
constexpr float kProjectorWidth = 3.0f;
constexpr float kTickWidth = 1.5f;
constexpr double kTickReach = 3.5;     // ImGui units to each side
constexpr double kTickDistance = 26.0;  // least, on average
constexpr float kNearAlpha = 0.95f;
constexpr float kFarAlpha = 0.12f;

std::vector<glm::dvec3> compute_rest_positions(const Skeleton& skeleton) {
  std::vector<glm::dvec3> positions;
  for (const Node& node : skeleton.nodes()) {
    positions.push_back(node.offset + (node.parent == kNoParent ? glm::dvec3(0.0) : positions[idx(node.parent)]));
  }
  return positions;
}

// Nodes that nothing hangs on.
std::vector<NodeIndex> find_ends(const Skeleton& skeleton) {
  std::vector<bool> has_child(idx(skeleton.node_count()), false);
  for (const Node& node : skeleton.nodes()) {
    if (node.parent != kNoParent) has_child[idx(node.parent)] = true;
  }
  std::vector<NodeIndex> ends;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (!has_child[idx(node)]) ends.push_back(node);
  }
  return ends;
}

float alpha_at(double frames_away, FrameRange shown) {
  const double share = std::clamp(std::abs(frames_away) / std::max(shown.count * 0.6, 1.0), 0.0, 1.0);
  return kFarAlpha + (kNearAlpha - kFarAlpha) * static_cast<float>((1.0 - share) * (1.0 - share));
}

// Frames from tick to tick: 1, 2, 5, 10 ... so that ticks keep their distance on the screen.
int tick_step(double pixels_per_frame) {
  int step = 1;
  for (const int factor : {2, 5, 10, 20, 50, 100, 200, 500}) {
    if (step * pixels_per_frame >= kTickDistance) break;
    step = factor;
  }
  return step;
}

}  // namespace

std::vector<NodeIndex> find_trail_nodes(const Skeleton& skeleton, const Selection& selection) {
  std::vector<NodeIndex> nodes;
  for (const JointIndex joint : selection.joints()) nodes.push_back(skeleton.node_of(joint));
  if (!nodes.empty()) return nodes;
  const std::vector<glm::dvec3> positions = compute_rest_positions(skeleton);
  std::vector<NodeIndex> ends = find_ends(skeleton);
  const auto reach = [&](NodeIndex node) { return glm::distance(positions[idx(node)], positions[0]); };
  sort_stably(ends, [&](NodeIndex a, NodeIndex b) { return reach(a) > reach(b); });
  const double apart = kEndsApart * compute_stature(skeleton);
  for (const NodeIndex end : ends) {
    const bool is_far = std::all_of(nodes.begin(), nodes.end(), [&](NodeIndex taken) {
      return glm::distance(positions[idx(end)], positions[idx(taken)]) >= apart;
    });
    if (is_far && size_of(nodes) < kMostEnds) nodes.push_back(end);
  }
  return nodes;
}

FrameRange find_trail_frames(FrameRange range, double frame_time_s, FrameIndex frame) {
  if (range.count * frame_time_s <= kWhole_s) return range;
  const int each_way = std::max(static_cast<int>(std::lround(kWindow_s / frame_time_s)), 1);
  const FrameIndex first = std::clamp(frame - each_way, range.first, range.end() - 1);
  const FrameIndex end = std::clamp(frame + each_way + 1, first + 1, range.end());
  return {first, end - first};
}

glm::vec3 Trails::point(const Trail& trail, FrameIndex frame) const {
  const float* at = trail.positions.data() + 3 * idx(frame - key_.frames.first);
  return {at[0], at[1], at[2]};
}

void Trails::compute_paths(const Session& session, const FigureCache& figure, FrameRange shown) {
  const Clip& clip = session.document.clip();
  const FrameIndex first = shown.first / kStretch * kStretch;
  const FrameIndex end = std::min((shown.end() + kStretch - 1) / kStretch * kStretch, clip.motion.frame_count());
  wanted_.frames = {first, end - first};
  wanted_.revision = session.document.revision();
  wanted_.figure_serial = figure.figure_serial();
  wanted_.joints = session.selection.joints();
  if (wanted_ == key_) return;
  key_ = wanted_;
  const std::vector<NodeIndex> nodes = find_trail_nodes(clip.skeleton, session.selection);
  trails_.resize(nodes.size());
  for (std::size_t i = 0; i < trails_.size(); ++i) {
    trails_[i].node = nodes[i];
    trails_[i].positions.resize(3 * idx(key_.frames.count));
    compute_node_path(clip.skeleton, clip.motion, key_.frames, clip.settings.position_rule, trails_[i].node,
                      trails_[i].positions);
  }
}

void Trails::add_line(const Trail& trail, FrameRange shown, double position, const glm::vec4& color,
                      Scene& scene) const {
  scene.lines.push_back({size_of(scene.line_points), shown.count, kWidth});
  for (FrameIndex frame = shown.first; frame < shown.end(); ++frame) {
    scene.line_points.push_back({point(trail, frame), glm::vec4(glm::vec3(color), alpha_at(frame - position, shown))});
  }
}

void Trails::add_ticks(const Trail& trail, FrameRange shown, double position, const CameraView& camera,
                       const glm::vec4& color, Scene& scene) const {
  double length = 0.0;
  for (FrameIndex frame = shown.first; frame + 1 < shown.end(); ++frame) {
    length += static_cast<double>(glm::distance(point(trail, frame), point(trail, frame + 1)));
  }
  const glm::vec3 back(camera.axes().back);
  const double scale = camera.units_per_pixel(camera.depth(glm::dvec3(point(trail, shown.first + shown.count / 2))));
  if (!(scale > 0.0) || !(length > 0.0)) return;
  const int step = tick_step(length / scale / shown.count);
  for (FrameIndex frame = (shown.first + step - 1) / step * step; frame < shown.end(); frame += step) {
    const glm::vec3 here = point(trail, frame);
    const glm::vec3 way = point(trail, std::min(frame + 1, shown.end() - 1)) - point(trail, std::max(frame - 1, shown.first));
    const glm::vec3 across = glm::cross(way, back);
    const float size = glm::length(across);
    if (!(size > 0.0f)) continue;
    const auto reach = static_cast<float>(kTickReach * camera.units_per_pixel(camera.depth(glm::dvec3(here))));
    const glm::vec4 tint(glm::vec3(color), alpha_at(frame - position, shown));
    scene.lines.push_back({size_of(scene.line_points), 2, kTickWidth});
    scene.line_points.push_back({here - across / size * reach, tint});
    scene.line_points.push_back({here + across / size * reach, tint});
  }
}

void Trails::add(const Session& session, const FigureCache& figure, const CameraView& camera,
                 const ViewOptions& options, const Theme& theme, Scene& scene) {
  const Motion& motion = session.document.motion();
  if (!options.show_trails || motion.frame_count() < 2) return;
  const Playback& playback = session.playback;
  const FrameRange shown = find_trail_frames(playback.range(), motion.frame_time_s(), playback.frame());
  compute_paths(session, figure, shown);
  const ImU32 side_colors[] = {theme.accent, theme.left, theme.right};
  for (const Trail& trail : trails_) {
    const JointIndex joint = session.document.skeleton().node(trail.node).joint;
    const glm::vec4 color = scene_color(side_colors[static_cast<int>(figure.shape().sides[idx(joint)])]);
    add_line(trail, shown, playback.position(), color, scene);
    if (options.projector) scene.lines.back().width = kProjectorWidth;
    add_ticks(trail, shown, playback.position(), camera, color, scene);
  }
}

}  // namespace marey::app
