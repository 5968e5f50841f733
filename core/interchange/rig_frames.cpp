#include "core/interchange/rig_frames.h"

#include <algorithm>
#include <cmath>

#include "core/math/angle.h"

namespace marey {
namespace {

constexpr double kRestTolerance_deg = 0.01;

bool starts_at_rest(const Rig& rig) {
  for (const RigJoint& joint : rig.joints) {
    for (const RigJoint::Curve& curve : joint.angles_deg) {
      if (std::abs(nearest_turn(curve.front(), 0.0)) > kRestTolerance_deg) return false;
    }
  }
  return true;
}

}  // namespace

Motion rest_frame(const Clip& clip, ExportChanges& changes) {
  Motion motion(clip.motion.channel_count(), 1, clip.motion.frame_time_s());
  for (ChannelIndex index = 0; index < motion.channel_count(); ++index) {
    const Channel& channel = clip.skeleton.channel(index);
    if (!is_position(channel.kind) || clip.skeleton.positions_add(channel.joint, clip.settings.position_rule)) continue;
    motion.channel_samples(index)[0] = clip.skeleton.offset(channel.joint)[static_cast<int>(axis_of(channel.kind))];
  }
  changes.push_back({ExportChangeKind::PoseAdded, false, 1, "The clip has no frames; the rest pose is written as one."});
  return motion;
}

void add_reference_pose(Rig& rig, ExportChanges& changes) {
  if (starts_at_rest(rig)) return;
  for (RigJoint& joint : rig.joints) {
    for (int axis = 0; axis < 3; ++axis) {
      RigJoint::Curve& curve = joint.positions[idx(axis)];
      if (curve.empty()) continue;
      curve.insert(curve.begin(), joint.parent == kNoParent ? double(curve.front()) : joint.offset[axis]);
    }
    for (RigJoint::Curve& curve : joint.angles_deg) curve.insert(curve.begin(), 0.0);
  }
  ++rig.frame_count;
  rig.starts_with_added_pose = true;
  changes.push_back({ExportChangeKind::PoseAdded, false, 1,
                     "The rest pose is added as the first frame; the movement starts in frame 2."});
}

}  // namespace marey
