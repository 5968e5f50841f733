#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/skeleton/skeleton.h"

namespace marey {

enum class QuantityKind : std::uint8_t {
  Position, Velocity, Acceleration, Angle, AngularVelocity, AngularAcceleration, Force, Torque, Power, Com, ComVelocity,
  Momentum, AngularMomentum, KineticEnergy, PotentialEnergy, Reaction, CentreOfPressure,
};

/// How often the pose has to be differentiated for a quantity.
enum class DerivativeLevel : std::uint8_t { Pose, Velocity, Acceleration };

/// Of what a quantity is.
enum class QuantityOwner : std::uint8_t {
  Body,         ///< of the whole body: no name behind it
  Point,        ///< of a joint or an end site
  Joint,        ///< of a joint
  BodyOrJoint,  ///< of the whole body, or with regard to a joint
};

/// A quantity as a value; one table has them all.
struct Quantity {
  std::string_view name;
  QuantityKind kind = QuantityKind::Position;
  QuantityOwner owner = QuantityOwner::Body;
  DerivativeLevel level = DerivativeLevel::Pose;
  bool needs_body = false;  ///< masses
  bool is_vector = true;
  std::string_view unit;
  std::string_view label;  ///< for people: "Centre of mass"
};

/// All that there are.
[[nodiscard]] std::span<const Quantity> quantities();
/// The one of a name; null for an unknown one.
[[nodiscard]] const Quantity* find_quantity(std::string_view name);

/// One quantity of one owner.
struct AskedQuantity {
  const Quantity* quantity = nullptr;
  NodeIndex node = kNoParent;  ///< kNoParent for the whole body
  std::string label;           ///< "torque:Body", "com"
};

/// "NAME" or "NAME:JOINT", '*' for every joint, or every joint and end site where the quantity is of points. Names as
/// node_label() gives them; of joints of one name the first is meant. Refused with InvalidArgument: a quantity or joint that
/// there is not, a missing or a needless joint; the message names what could stand there.
[[nodiscard]] Result<std::vector<AskedQuantity>> find_quantities(const Skeleton& skeleton, std::span<const std::string> texts);

}  // namespace marey
