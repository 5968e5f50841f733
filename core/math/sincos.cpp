#include "core/math/sincos.h"

#include <cmath>

namespace marey::sincos_detail {

double within_one_turn(double angle_deg) {
  return std::abs(angle_deg) > kLargeAngleDeg ? std::fmod(angle_deg, 360.0) : angle_deg;
}

Lanes within_one_turn(const Lanes& angle_deg) { 
  return Lanes{within_one_turn(angle_deg[0]), within_one_turn(angle_deg[1])};
}

}  // namespace marey::sincos_detail
