#include "core/biomechanics/quantity.h"

#include <algorithm>
#include <array>

namespace marey {
namespace {

using Kind = QuantityKind;
using Owner = QuantityOwner;
using Level = DerivativeLevel;
using Sight = QuantitySight;

constexpr std::array kQuantities = {
    Quantity{"position", Kind::Position, Owner::Point, Level::Pose, Sight::Place, false, true, "m", "Position"},
    Quantity{"velocity", Kind::Velocity, Owner::Point, Level::Velocity, Sight::Place, false, true, "m/s", "Velocity"},
    Quantity{"acceleration", Kind::Acceleration, Owner::Point, Level::Acceleration, Sight::Place, false, true, "m/s2", "Acceleration"},
    Quantity{"path_length", Kind::PathLength, Owner::Point, Level::Pose, Sight::Place, false, false, "m", "Path length"},
    Quantity{"angle", Kind::Angle, Owner::Joint, Level::Pose, Sight::Rotation, false, true, "rad", "Angle"},
    Quantity{"angle_rate", Kind::AngleRate, Owner::Joint, Level::Velocity, Sight::None, false, true, "rad/s", "Angle rate"},
    Quantity{"rotation_angle", Kind::RotationAngle, Owner::Joint, Level::Pose, Sight::Rotation, false, false, "rad", "Rotation angle"},
    Quantity{"rotation_axis", Kind::RotationAxis, Owner::Joint, Level::Pose, Sight::Rotation, false, true, "1", "Rotation axis"},
    Quantity{"plane_angle", Kind::PlaneAngle, Owner::Joint, Level::Pose, Sight::Arrow, false, true, "rad", "Plane angle"},
    Quantity{"included_angle", Kind::IncludedAngle, Owner::Joint, Level::Pose, Sight::None, false, false, "rad", "Included angle"},
    Quantity{"angular_velocity", Kind::AngularVelocity, Owner::Joint, Level::Velocity, Sight::Rotation, false, true, "rad/s", "Angular velocity"},
    Quantity{"angular_acceleration", Kind::AngularAcceleration, Owner::Joint, Level::Acceleration, Sight::Rotation, false, true, "rad/s2", "Angular acceleration"},
    Quantity{"segment_com", Kind::SegmentCom, Owner::Joint, Level::Pose, Sight::Place, true, true, "m", "Segment centre"},
    Quantity{"segment_com_velocity", Kind::SegmentComVelocity, Owner::Joint, Level::Velocity, Sight::Place, true, true, "m/s", "Velocity of the segment centre"},
    Quantity{"segment_com_acceleration", Kind::SegmentComAcceleration, Owner::Joint, Level::Acceleration, Sight::Place, true, true, "m/s2", "Acceleration of the segment centre"},
    Quantity{"force", Kind::Force, Owner::Joint, Level::Acceleration, Sight::Arrow, true, true, "N", "Joint force"},
    Quantity{"torque", Kind::Torque, Owner::Joint, Level::Acceleration, Sight::Arrow, true, true, "N.m", "Joint torque"},
    Quantity{"power", Kind::Power, Owner::Joint, Level::Acceleration, Sight::None, true, false, "W", "Joint power"},
    Quantity{"work", Kind::Work, Owner::Joint, Level::Acceleration, Sight::None, true, false, "J", "Joint work"},
    Quantity{"com", Kind::Com, Owner::Body, Level::Pose, Sight::Place, true, true, "m", "Centre of mass"},
    Quantity{"com_velocity", Kind::ComVelocity, Owner::Body, Level::Velocity, Sight::Place, true, true, "m/s", "Velocity of the centre of mass"},
    Quantity{"momentum", Kind::Momentum, Owner::Body, Level::Velocity, Sight::Arrow, true, true, "kg.m/s", "Momentum"},
    Quantity{"angular_momentum", Kind::AngularMomentum, Owner::BodyOrJoint, Level::Velocity, Sight::Arrow, true, true, "kg.m2/s", "Angular momentum"},
    Quantity{"kinetic_energy", Kind::KineticEnergy, Owner::Body, Level::Velocity, Sight::None, true, false, "J", "Kinetic energy"},
    Quantity{"potential_energy", Kind::PotentialEnergy, Owner::Body, Level::Pose, Sight::None, true, false, "J", "Potential energy"},
    Quantity{"energy", Kind::Energy, Owner::Body, Level::Velocity, Sight::None, true, false, "J", "Mechanical energy"},
    Quantity{"reaction", Kind::Reaction, Owner::Body, Level::Acceleration, Sight::Arrow, true, true, "N", "Support reaction"},
    Quantity{"cop", Kind::CentreOfPressure, Owner::Body, Level::Acceleration, Sight::Place, true, true, "m", "Centre of pressure"},
    Quantity{"zmp", Kind::ZeroMomentPoint, Owner::Body, Level::Acceleration, Sight::Place, true, true, "m", "Zero-moment point"}};

}  // namespace

std::span<const Quantity> quantities() { return kQuantities; }

const Quantity* find_quantity(std::string_view name) {
  const auto found = std::find_if(kQuantities.begin(), kQuantities.end(), [&](const Quantity& q) { return q.name == name; });
  return found == kQuantities.end() ? nullptr : &*found;
}

}  // namespace marey
