#include "core/biomechanics/quantity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace marey {
namespace {

using Kind = QuantityKind;
using Owner = QuantityOwner;
using Level = DerivativeLevel;

constexpr std::array kQuantities = {
    Quantity{"position", Kind::Position, Owner::Point, Level::Pose, false, true, "m", "Position"},
    Quantity{"velocity", Kind::Velocity, Owner::Point, Level::Velocity, false, true, "m/s", "Velocity"},
    Quantity{"acceleration", Kind::Acceleration, Owner::Point, Level::Acceleration, false, true, "m/s2", "Acceleration"},
    Quantity{"angle", Kind::Angle, Owner::Joint, Level::Pose, false, true, "rad", "Angle"},
    Quantity{"angular_velocity", Kind::AngularVelocity, Owner::Joint, Level::Velocity, false, true, "rad/s", "Angular velocity"},
    Quantity{"angular_acceleration", Kind::AngularAcceleration, Owner::Joint, Level::Acceleration, false, true, "rad/s2", "Angular acceleration"},
    Quantity{"force", Kind::Force, Owner::Joint, Level::Acceleration, true, true, "N", "Joint force"},
    Quantity{"torque", Kind::Torque, Owner::Joint, Level::Acceleration, true, true, "N.m", "Joint torque"},
    Quantity{"power", Kind::Power, Owner::Joint, Level::Acceleration, true, false, "W", "Joint power"},
    Quantity{"com", Kind::Com, Owner::Body, Level::Pose, true, true, "m", "Centre of mass"},
    Quantity{"com_velocity", Kind::ComVelocity, Owner::Body, Level::Velocity, true, true, "m/s", "Velocity of the centre of mass"},
    Quantity{"momentum", Kind::Momentum, Owner::Body, Level::Velocity, true, true, "kg.m/s", "Momentum"},
    Quantity{"angular_momentum", Kind::AngularMomentum, Owner::BodyOrJoint, Level::Velocity, true, true, "kg.m2/s", "Angular momentum"},
    Quantity{"kinetic_energy", Kind::KineticEnergy, Owner::Body, Level::Velocity, true, false, "J", "Kinetic energy"},
    Quantity{"potential_energy", Kind::PotentialEnergy, Owner::Body, Level::Pose, true, false, "J", "Potential energy"},
    Quantity{"reaction", Kind::Reaction, Owner::Body, Level::Acceleration, true, true, "N", "Support reaction"},
    Quantity{"cop", Kind::CentreOfPressure, Owner::Body, Level::Acceleration, true, true, "m", "Centre of pressure"}};

Error refusal(std::string message, std::string_view found) {
  return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, std::string(found)};
}

std::string known_names() {
  std::vector<std::string_view> names;
  for (const Quantity& quantity : kQuantities) names.push_back(quantity.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

Status add_owners(const Skeleton& skeleton, const Quantity& quantity, std::string_view wanted, std::vector<AskedQuantity>& asked) {
  const std::size_t before = asked.size();
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (skeleton.node(node).is_end_site && quantity.owner != Owner::Point) continue;
    std::string label = node_label(skeleton, node);
    if (wanted != "*" && label != wanted) continue;
    asked.push_back({&quantity, node, fmt::format("{}:{}", quantity.name, label)});
    if (wanted != "*") return {};
  }
  if (asked.size() > before) return {};
  return refusal(fmt::format("There is no joint '{}'{}.", wanted, quantity.owner == Owner::Point ? " and no such end site" : ""), wanted);
}

}  // namespace

std::span<const Quantity> quantities() { return kQuantities; }

const Quantity* find_quantity(std::string_view name) {
  const auto found = std::find_if(kQuantities.begin(), kQuantities.end(), [&](const Quantity& q) { return q.name == name; });
  return found == kQuantities.end() ? nullptr : &*found;
}

Result<std::vector<AskedQuantity>> find_quantities(const Skeleton& skeleton, std::span<const std::string> texts) {
  std::vector<AskedQuantity> asked;
  for (const std::string& text : texts) {
    const std::size_t colon = text.find(':');
    const std::string_view name = std::string_view(text).substr(0, colon);
    const Quantity* found = find_quantity(name);
    if (found == nullptr) return refusal(fmt::format("'{}' is not a quantity; there are {}.", name, known_names()), name);
    if (colon == std::string::npos) {
      if (found->owner == Owner::Point || found->owner == Owner::Joint) {
        return refusal(fmt::format("'{0}' is of a joint: write {0}:JOINT, or {0}:* for all.", name), name);
      }
      asked.push_back({found, kNoParent, std::string(name)});
      continue;
    }
    if (found->owner == Owner::Body) return refusal(fmt::format("'{}' is of the whole body; no joint stands behind it.", name), name);
    if (Status status = add_owners(skeleton, *found, std::string_view(text).substr(colon + 1), asked); !status) return status.error();
  }
  return asked;
}

}  // namespace marey
