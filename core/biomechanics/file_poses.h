#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/motion/clip.h"

namespace marey {

/// Where the joints and end sites of a clip are as the file has them, before any smoothing. World axes.
struct FilePoses {
  int node_count = 0;
  int joint_count = 0;
  std::vector<double> positions_m;    ///< [frame][node][x y z]
  std::vector<glm::dquat> rotations;  ///< [frame][joint], unit length; empty unless they were asked for

  [[nodiscard]] glm::dvec3 position(FrameIndex frame, NodeIndex node) const {
    const double* at = positions_m.data() + 3 * (idx(frame) * idx(node_count) + idx(node));
    return {at[0], at[1], at[2]};
  }
  [[nodiscard]] const glm::dquat& rotation(FrameIndex frame, JointIndex joint) const {
    return rotations[idx(frame) * idx(joint_count) + idx(joint)];
  }
};

[[nodiscard]] FilePoses find_file_poses(const Clip& clip, double metres_per_unit, bool with_rotations);

}  // namespace marey
