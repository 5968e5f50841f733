#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/biomechanics/asked_quantity.h"
#include "core/biomechanics/body_model.h"
#include "core/biomechanics/derivation.h"
#include "core/biomechanics/support.h"
#include "core/motion/clip.h"

namespace marey {

/// What is wanted of a clip.
struct AnalysisRequest {
  std::vector<std::string> quantities;  ///< "torque:Body", "com"; "position:*" is of every joint and end site
  std::vector<AskedQuantity> asked{};   ///< further ones; by node, as names may stand twice
  std::optional<BodyModel> model;       ///< needed by all that has to do with mass
  SupportKind support = SupportKind::Auto;
  Derivation derivation;
  std::optional<double> frame_time_s;  ///< in place of the clip's
  std::vector<OwnContact> contacts{};  ///< in place of what paths tell, where the body stands on the ground
  std::optional<SettledSupport> settled{};  ///< in place of looking for what `support` says
};

/// One number per frame.
struct AnalysisColumn {
  std::string name;            ///< with its unit: "torque:Body.x[N.m]"
  AskedQuantity asked;         ///< what it is of
  char component = 0;          ///< 'x', 'y' or 'z'; 0 for a quantity without direction
  std::vector<double> values;  ///< not a number where the value is not defined
};

struct AnalysisTable {
  std::vector<AnalysisColumn> columns;
  std::vector<std::string> notes;  ///< sentences about what people should know of it
  std::optional<SettledSupport> support{};  ///< none where nothing needed masses

  /// Those of the ground; null where something else holds the body.
  [[nodiscard]] const Contacts* contacts() const { return support && support->kind == SupportKind::Ground ? &support->contacts : nullptr; }
};

/// World axes, SI, one column per component:
///   position velocity acceleration   of a joint, an end site or a point fixed to a joint, of its path
///   path_length                      of that path so far
///   angle angle_rate                 of a joint: its rotation channels, without jumps of whole turns, and their derivatives
///   rotation_angle rotation_axis     of a joint in its parent: by how much and about what it is turned, the short way
///   plane_angle                      of a joint's bone: its direction in the three planes, see angles_in_planes()
///   included_angle                   at a joint, between the bone before it and its own: pi where it is straight
///   angular_velocity angular_acceleration  of a joint's frame in the world
///   segment_com segment_com_velocity segment_com_acceleration  of the centre of what a joint carries
///   force torque                     on a joint's segment from its parent (a root: from the world), at the joint's origin
///   power work                       of that torque, by the joint's angular velocity in its parent; work from the first frame on
///   com com_velocity momentum kinetic_energy potential_energy energy  of the body; energy is the sum of both
///   angular_momentum                 about the centre of mass; with a joint, about the joint's origin
///   reaction cop                     of the support: the force on the body, and where it presses on the floor
///   zmp                              where a floor would press for the body to move so, contact or not
/// Seen from a frame of reference, places are from its origin in its axes, and their derivatives those of what is seen there;
/// angle and rotation_* are of the joint's rotation against that frame, angle then in the order of the joint's channels;
/// angular_velocity and angular_acceleration are relative to it; forces, torques and momenta are turned into its axes.
/// Angles are those of the file's own pose, whatever the derivation smooths.
/// Frames in which differences are one-sided have no velocity and no acceleration. Errors: InvalidArgument for a quantity or
/// joint that there is not, and without a model that is needed; those of find_body_motion() and check_body_model().
[[nodiscard]] Result<AnalysisTable> analyse(const Clip& clip, const AnalysisRequest& request);

}  // namespace marey
