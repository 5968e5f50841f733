#include "core/biomechanics/file_poses.h"

#include "core/kinematics/forward_kinematics.h"
#include "core/kinematics/pose.h"

namespace marey {

FilePoses find_file_poses(const Clip& clip, double metres_per_unit, bool with_rotations) {
  const Skeleton& skeleton = clip.skeleton;
  const int frames = clip.motion.frame_count();
  FilePoses poses{skeleton.node_count(), skeleton.joint_count(), {}, {}};
  poses.positions_m.resize(idx(frames) * idx(poses.node_count) * 3);
  compute_world_positions(skeleton, clip.motion, {0, frames}, clip.settings.position_rule, poses.positions_m);
  for (double& coordinate : poses.positions_m) coordinate *= metres_per_unit;
  if (!with_rotations) return poses;
  LocalPose local;
  WorldPose world;
  local.resize(skeleton);
  world.resize(skeleton);
  for (FrameIndex frame = 0; frame < frames; ++frame) {
    compute_local_pose(skeleton, clip.motion, frame, clip.settings.position_rule, local);
    compute_world_pose(skeleton, local, world);
    poses.rotations.insert(poses.rotations.end(), world.world_rotations.begin(), world.world_rotations.end());
  }
  return poses;
}

}  // namespace marey
