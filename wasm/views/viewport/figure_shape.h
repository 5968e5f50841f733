#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/kinematics/pose.h"
#include "core/motion/clip.h"
#include "core/skeleton/body_side.h"

namespace marey::app {

/// Solid between two nodes. It belongs to the joint that turns it: the one it starts at.
struct FigureBone {
  NodeIndex from = 0;
  NodeIndex to = 0;
  JointIndex joint = 0;
  double radius = 0.0;                   ///< file units
  BodySide side = BodySide::Middle;      ///< of the joint
  glm::dvec3 local_side{1.0, 0.0, 0.0};  ///< unit, in the joint's axes, across the bone: shows how the bone rolls
};

/// Ball at a joint, the small tip of an end site, or a head.
struct FigureBall {
  NodeIndex node = 0;
  NodeIndex parent = 0;  ///< of the node; the node itself for a root
  JointIndex joint = 0;
  double radius = 0.0;
  BodySide side = BodySide::Middle;
  bool is_tip = false;
  bool is_head = false;
  double share_to_parent = 0.0;  ///< 0 at the node ... 1 at its parent: a head sits between neck and top
};

/// How a figure is built of solids: all that stays the same while it moves.
struct FigureShape {
  double size = 1.0;  ///< stature, or the extent of the first pose where offsets are all 0; > 0
  std::vector<FigureBone> bones;  ///< none without length
  std::vector<FigureBall> balls;  ///< at most one per place
  std::vector<BodySide> sides;    ///< per joint
  /// Bones from a root that only marks the origin to the body that moves freely below it: drawn as a line.
  std::vector<FigureBone> tethers;
};

/// Thickness follows the figure: a limb is as thick as the part of the body that hangs on it asks for, so that thighs,
/// fingers and the links of a three-link gymnast all look right. `reference`: world pose of the first frame.
[[nodiscard]] FigureShape make_figure_shape(const Clip& clip, const WorldPose& reference);

}  // namespace marey::app
