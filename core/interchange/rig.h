#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/interchange/export.h"
#include "core/math/axis.h"
#include "core/motion/clip.h"

namespace marey {

/// An end site of a RigJoint.
struct RigEnd {
  glm::dvec3 offset{0.0};
  std::string name;
  NodeIndex origin = kNoParent;  ///< node of the clip; kNoParent for an added one
};

/// A joint with its curves, in a form that is easy to change: positions replace OFFSET, positions before rotations.
struct RigJoint {
  using Curve = std::vector<double>;  ///< one sample per frame

  std::string name;
  JointIndex parent = kNoParent;
  glm::dvec3 offset{0.0};
  std::array<Curve, 3> positions;  ///< in the parent's frame, file units; empty: no channel, the joint stays at offset
  std::vector<Axis> axes;          ///< of the rotations, from left to right
  std::vector<Curve> angles_deg;   ///< one for each axis
  std::vector<RigEnd> end_sites;
  NodeIndex origin = kNoParent;    ///< node of the clip; kNoParent for an added joint

  [[nodiscard]] bool has_positions() const;
  /// Where the joint is in its parent's frame.
  [[nodiscard]] glm::dvec3 place(FrameIndex frame) const;
};

/// A clip taken apart. Joints stand parents first, each subtree together.
struct Rig {
  std::vector<RigJoint> joints;
  int frame_count = 0;
  double frame_time_s = 0.0;
  bool starts_with_added_pose = false;

  /// For each joint whether it has any.
  [[nodiscard]] std::vector<bool> with_children() const;
};

/// What was done so far; `changes` grows.
using ExportChanges = std::vector<ExportChange>;

/// Takes a clip apart. Channels that are neither positions nor rotations, and samples too small to move anything
/// (below 1e-30, which some readers refuse), are left out. The clip has at least one frame.
[[nodiscard]] Rig make_rig(const Clip& clip, ExportChanges& changes);

/// Puts it together for a program that has the given rule. `changes` and `names` of the result stay empty.
[[nodiscard]] Result<ExportedClip> assembled(const Rig& rig, PositionRule rule, int original_node_count);

/// "'A', 'B', 'C' and 17 more".
[[nodiscard]] std::string listed_joints(const Rig& rig, const std::vector<JointIndex>& joints);

}  // namespace marey
