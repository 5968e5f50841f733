#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/biomechanics/body_model.h"
#include "core/biomechanics/derivation.h"
#include "core/biomechanics/quantity.h"
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
};

/// One number per frame.
struct AnalysisColumn {
  std::string name;            ///< with its unit: "torque:Body.x[N.m]"
  const Quantity* quantity = nullptr;
  NodeIndex node = kNoParent;  ///< of whom; kNoParent for the whole body
  char component = 0;          ///< 'x', 'y' or 'z'; 0 for a quantity without direction
  std::vector<double> values;  ///< not a number where the value is not defined
};

struct AnalysisTable {
  std::vector<AnalysisColumn> columns;
  std::vector<std::string> notes;  ///< sentences about what people should know of it
};

/// World axes, SI, one column per component:
///   position velocity acceleration   of a joint or an end site, of its path through the world
///   angle                            of a joint: its rotation channels, without jumps of whole turns
///   angular_velocity angular_acceleration  of a joint's frame in the world
///   force torque                     on a joint's segment from its parent (a root: from the world), at the joint's origin
///   power                            of that torque, by the joint's angular velocity in its parent
///   com com_velocity momentum kinetic_energy potential_energy  of the body
///   angular_momentum                 about the centre of mass; with a joint, about the joint's origin
///   reaction cop                     of the support: the force on the body, and where it presses on the floor
/// Frames in which differences are one-sided have no velocity and no acceleration. Errors: InvalidArgument for a quantity or
/// joint that there is not, and without a model that is needed; those of find_body_motion() and check_body_model().
[[nodiscard]] Result<AnalysisTable> analyse(const Clip& clip, const AnalysisRequest& request);

}  // namespace marey
