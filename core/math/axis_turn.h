#pragma once

#include "core/math/axis.h"
#include "core/math/sincos.h"

namespace marey {

/// q times the rotation about one axis whose half angle has the given sine and cosine; half the terms of a full
/// product. `Quat` has members w x y z of type T and is made from them in this order: glm::dquat, or one of Lanes.
template <class Quat, class T>
[[nodiscard]] inline Quat turned_about(const Quat& q, Axis axis, const SinCos<T>& half) {
  const T& s = half.sine;
  const T& c = half.cosine;
  switch (axis) {
    case Axis::X: return Quat{q.w * c - q.x * s, q.x * c + q.w * s, q.y * c + q.z * s, q.z * c - q.y * s};
    case Axis::Y: return Quat{q.w * c - q.y * s, q.x * c - q.z * s, q.y * c + q.w * s, q.z * c + q.x * s};
    case Axis::Z: break;
  }
  return Quat{q.w * c - q.z * s, q.x * c + q.y * s, q.y * c - q.x * s, q.z * c + q.w * s};
}

}  // namespace marey
