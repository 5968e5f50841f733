#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/motion/motion.h"
#include "core/skeleton/position_rule.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// Transform of every joint relative to its parent, in file units. Buffers are sized once and reused.
struct LocalPose {
  std::vector<glm::dvec3> local_translations;  ///< per joint
  std::vector<glm::dquat> local_rotations;     ///< per joint, unit length

  /// Room for what computing a pose needs in between, per channel.
  struct Scratch {
    std::vector<double> samples;
    std::vector<double> half_sines;
    std::vector<double> half_cosines;
  };
  Scratch scratch;

  void resize(const Skeleton& skeleton);
};

/// Where a joint stands in its parent (a root: in the world): its offset and its position channels, as `rule` reads them.
[[nodiscard]] glm::dvec3 joint_translation(const Skeleton& skeleton, const Motion& motion, JointIndex joint, FrameIndex frame,
                                           PositionRule rule);

/// World transforms. World axes are the file's; a joint's own rotation turns its children, never its own origin.
struct WorldPose {
  std::vector<glm::dvec3> world_positions;  ///< per node (joints and end sites)
  std::vector<glm::dquat> world_rotations;  ///< per joint, unit length

  void resize(const Skeleton& skeleton);
};

/// Local pose of one frame. R = product of the rotation channels from left to right (theory.md 1.1).
/// `local` must be resized for `skeleton`. 0 <= frame < frame_count. Does not allocate.
void compute_local_pose(const Skeleton& skeleton, const Motion& motion, FrameIndex frame, PositionRule rule,
                        LocalPose& local);

/// Local pose between frames: positions linear, rotations of joints with several rotation channels by slerp along the
/// short way, joints with one rotation channel linear in the angle. `frame` is clamped to [0, frame_count - 1].
/// Whole numbers give the frame's own pose. Does not allocate.
void compute_local_pose_between(const Skeleton& skeleton, const Motion& motion, double frame, PositionRule rule,
                                LocalPose& local);

/// All channels zero: the figure as its offsets draw it.
void compute_rest_pose(const Skeleton& skeleton, LocalPose& local);

/// Chains the local transforms from the roots down. `world` must be resized for `skeleton`. Does not allocate.
void compute_world_pose(const Skeleton& skeleton, const LocalPose& local, WorldPose& world);

}  // namespace marey
