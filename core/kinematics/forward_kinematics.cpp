#include "core/kinematics/forward_kinematics.h"

#include "core/kinematics/pose.h"

namespace marey {
namespace {

template <class Number>
void compute_positions(const Skeleton& skeleton, const Motion& motion, FrameRange frames, PositionRule rule,
                       std::span<Number> world_positions) {
  LocalPose local;
  WorldPose world;
  local.resize(skeleton);
  world.resize(skeleton);
  std::size_t out = 0;
  for (FrameIndex frame = frames.first; frame < frames.end(); ++frame) {
    compute_local_pose(skeleton, motion, frame, rule, local);
    compute_world_pose(skeleton, local, world);
    for (const glm::dvec3& position : world.world_positions) {
      for (int axis = 0; axis < 3; ++axis) world_positions[out++] = static_cast<Number>(position[axis]);
    }
  }
}

}  // namespace

void compute_world_positions(const Skeleton& skeleton, const Motion& motion, FrameRange frames, PositionRule rule,
                             std::span<double> world_positions) {
  compute_positions(skeleton, motion, frames, rule, world_positions);
}

void compute_world_positions(const Skeleton& skeleton, const Motion& motion, FrameRange frames, PositionRule rule,
                             std::span<float> world_positions) {
  compute_positions(skeleton, motion, frames, rule, world_positions);
}

void compute_node_path(const Skeleton& skeleton, const Motion& motion, FrameRange frames, PositionRule rule,
                       NodeIndex node, std::span<float> world_positions) {
  std::vector<float> all(idx(skeleton.node_count()) * 3);
  for (FrameIndex i = 0; i < frames.count; ++i) {
    compute_world_positions(skeleton, motion, {frames.first + i, 1}, rule, std::span<float>(all));
    for (int axis = 0; axis < 3; ++axis) world_positions[idx(3 * i + axis)] = all[idx(3 * node + axis)];
  }
}

}  // namespace marey
