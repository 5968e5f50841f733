#include "core/math/sincos.h"

#include <cmath>

namespace marey {

SinCos<double> sincos_deg(double angle_deg) {
  // fmod is exact for any size of angle.
  return sincos_small_deg(std::abs(angle_deg) > kLargeAngleDeg ? std::fmod(angle_deg, 360.0) : angle_deg);
}

}  // namespace marey
