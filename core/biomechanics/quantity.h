#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace marey {

enum class QuantityKind : std::uint8_t {
  Position, Velocity, Acceleration, PathLength, Angle, AngleRate, RotationAngle, RotationAxis, PlaneAngle, IncludedAngle,
  AngularVelocity, AngularAcceleration, SegmentCom, SegmentComVelocity, SegmentComAcceleration, Force, Torque, Power, Work, Com,
  ComVelocity, Momentum, AngularMomentum, KineticEnergy, PotentialEnergy, Energy, Reaction, CentreOfPressure, ZeroMomentPoint,
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

/// What is asked of the pose for a quantity, and what another frame of reference makes of it.
enum class QuantitySight : std::uint8_t {
  Place,     ///< a place, or how it changes: seen from the origin of the frame, in its axes, as it moves
  Rotation,  ///< a rotation, or how it changes: against the frame, in its axes
  Arrow,     ///< turned into the axes of the frame
  None,      ///< the same from everywhere
};

/// A quantity as a value; one table has them all.
struct Quantity {
  std::string_view name;
  QuantityKind kind = QuantityKind::Position;
  QuantityOwner owner = QuantityOwner::Body;
  DerivativeLevel level = DerivativeLevel::Pose;
  QuantitySight sight = QuantitySight::None;
  bool needs_body = false;  ///< masses
  bool is_vector = true;
  std::string_view unit;
  std::string_view label;  ///< for people: "Centre of mass"
};

/// All that there are.
[[nodiscard]] std::span<const Quantity> quantities();
/// The one of a name; null for an unknown one.
[[nodiscard]] const Quantity* find_quantity(std::string_view name);

}  // namespace marey
