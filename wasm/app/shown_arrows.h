#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace marey::app {

/// Arrows in the view of the figure: those of joints at their origins, the others at the centre of mass and on the ground.
enum class BodyArrow : std::uint8_t { Velocity, Acceleration, Force, Torque, AngularMomentum, Reaction };
inline constexpr int kBodyArrowCount = 6;

/// What of the mechanics is drawn into the view.
struct ShownArrows {
  bool com = false;  ///< the centre of mass with its path and its place on the ground
  bool arrows[kBodyArrowCount] = {};

  friend bool operator==(const ShownArrows&, const ShownArrows&) = default;
  [[nodiscard]] bool any() const { return com || std::find(std::begin(arrows), std::end(arrows), true) != std::end(arrows); }
  [[nodiscard]] bool shows(BodyArrow arrow) const { return arrows[static_cast<int>(arrow)]; }
};

}  // namespace marey::app
