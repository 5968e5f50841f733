#include "wasm/views/viewport/figure_cache.h"

#include <cmath>
#include <glm/common.hpp>

namespace marey::app {
namespace {

Box box_around(const std::vector<glm::dvec3>& positions) {
  Box box{glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL)};
  for (const glm::dvec3& position : positions) {
    if (!std::isfinite(position.x + position.y + position.z)) continue;
    box = {glm::min(box.low, position), glm::max(box.high, position)};
  }
  return box.low.x <= box.high.x ? box : Box{};
}

}  // namespace

void compute_clip_pose(const Clip& clip, double position, LocalPose& local, WorldPose& world) {
  if (size_of(local.local_rotations) != clip.skeleton.joint_count() ||
      size_of(world.world_positions) != clip.skeleton.node_count()) {
    local.resize(clip.skeleton);
    world.resize(clip.skeleton);
  }
  if (clip.motion.frame_count() > 0) {
    compute_local_pose_between(clip.skeleton, clip.motion, position, clip.settings.position_rule, local);
  } else {
    compute_rest_pose(clip.skeleton, local);
  }
  compute_world_pose(clip.skeleton, local, world);
}

void FigureCache::rebuild(const Clip& clip) {
  compute_clip_pose(clip, 0.0, local_, pose_);
  shape_ = make_figure_shape(clip, pose_);
  const double light_yaw_rad = stage_.light_yaw_rad;
  stage_ = measure_stage(clip, shape_);
  stage_.light_yaw_rad = light_yaw_rad;
  skeleton_ = clip.skeleton;
  settings_ = clip.settings;
  ++figure_serial_;
}

void FigureCache::measure_bounds(const Clip& clip) {
  stage_.bounds = compute_clip_bounds(clip.skeleton, clip.motion, clip.settings.position_rule);
}

void FigureCache::compute_pose(const Clip& clip, double position) {
  compute_clip_pose(clip, position, local_, pose_);
  pose_box_ = box_around(pose_.world_positions);
}

void FigureCache::update(const Session& session, std::uint64_t clip_serial) {
  const Clip& clip = session.document.clip();
  const std::uint64_t revision = session.document.revision();
  const double position = session.playback.position();
  const bool changed = clip_serial != clip_serial_ || revision != revision_ || figure_serial_ == 0;
  if (changed && (clip_serial != clip_serial_ || settings_ != clip.settings || skeleton_ != clip.skeleton)) rebuild(clip);
  if (changed || position != position_) compute_pose(clip, position);
  clip_serial_ = clip_serial;
  revision_ = revision;
  position_ = position;
}

}  // namespace marey::app
