#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "core/base/index.h"
#include "core/kinematics/block_kernels.h"
#include "core/math/axis_turn.h"
#include "core/math/sincos.h"

// Templates over the width of a register. Everything in here that is not constexpr depends on L: the linker must not take
// a function that was compiled for a wide register into the code for any processor.
namespace marey::block_kernels_detail {

template <class L>
inline constexpr int kLanesOf = static_cast<int>(sizeof(L) / sizeof(double));

template <class L>
L load(const BlockColumn& column, int i) {
  L lanes;
  std::memcpy(&lanes, &column[idx(i)], sizeof lanes);
  return lanes;
}

template <class L>
void store(BlockColumn& column, int i, const L& lanes) {
  std::memcpy(&column[idx(i)], &lanes, sizeof lanes);
}

template <class L>
struct Quaternion {
  L w, x, y, z;
};

/// Halves the angles into `halves`, filled up with 0; true if one of them is too large for sincos_small_deg().
template <class L>
bool halve(const double* angles_deg, int count, BlockColumn& halves) {
  using sincos_detail::kLargeAngleDeg;
  const int whole = count - count % kLanesOf<L>;
  const int filled = std::min(whole + kLanesOf<L>, kMostBlockFrames);
  for (int i = whole; i < filled; ++i) halves[idx(i)] = i < count ? 0.5 * angles_deg[i] : 0.0;
  auto large = L{} > 0.0;
  for (int i = 0; i < whole; i += kLanesOf<L>) {
    L angle;
    std::memcpy(&angle, angles_deg + i, sizeof angle);
    angle *= 0.5;
    large |= (angle > kLargeAngleDeg) | (angle < -kLargeAngleDeg);
    store(halves, i, angle);
  }
  bool is_large = false;
  for (int lane = 0; lane < kLanesOf<L>; ++lane) is_large = is_large || large[lane] != 0;
  for (int i = whole; i < count; ++i) is_large = is_large || std::abs(halves[idx(i)]) > kLargeAngleDeg;
  return is_large;
}

template <class L, class Bits>
void find_half_turns(const double* angles_deg, int count, BlockColumn& sines, BlockColumn& cosines) {
  BlockColumn halves;
  if (halve<L>(angles_deg, count, halves)) [[unlikely]] {
    for (int i = 0; i < count; ++i) halves[idx(i)] = sincos_detail::within_one_turn(halves[idx(i)]);
  }
  // A loop of its own, so that nothing waits for the end of one angle's chain.
  for (int i = 0; i < count; i += kLanesOf<L>) {
    const SinCos<L> half = sincos_detail::sincos_small_deg<L, Bits>(load<L>(halves, i));
    store(sines, i, half.sine);
    store(cosines, i, half.cosine);
  }
}

template <class L>
Quaternion<L> load(const QuaternionColumns& columns, int i) {
  return {load<L>(columns.w, i), load<L>(columns.x, i), load<L>(columns.y, i), load<L>(columns.z, i)};
}

template <class L, Axis axis>
void turn_about(const BlockColumn& half_sines, const BlockColumn& half_cosines, const QuaternionColumns& from, int count,
                QuaternionColumns& to) {
  for (int i = 0; i < count; i += kLanesOf<L>) {
    const SinCos<L> half{load<L>(half_sines, i), load<L>(half_cosines, i)};
    const Quaternion<L> turned = turned_about(load<L>(from, i), axis, half);
    store(to.w, i, turned.w);
    store(to.x, i, turned.x);
    store(to.y, i, turned.y);
    store(to.z, i, turned.z);
  }
}

template <class L>
void turn(Axis axis, const BlockColumn& half_sines, const BlockColumn& half_cosines, const QuaternionColumns& from, int count,
          QuaternionColumns& to) {
  switch (axis) {
    case Axis::X: return turn_about<L, Axis::X>(half_sines, half_cosines, from, count, to);
    case Axis::Y: return turn_about<L, Axis::Y>(half_sines, half_cosines, from, count, to);
    case Axis::Z: return turn_about<L, Axis::Z>(half_sines, half_cosines, from, count, to);
  }
}

/// q v conjugate(q) for unit q.
template <class L>
void place(const QuaternionColumns& rotation, const PositionColumns& origin, const PositionColumns& local, int count,
           PositionColumns& world) {
  for (int i = 0; i < count; i += kLanesOf<L>) {
    const Quaternion<L> q = load<L>(rotation, i);
    const L vx = load<L>(local.x, i);
    const L vy = load<L>(local.y, i);
    const L vz = load<L>(local.z, i);
    const L x = 2.0 * (q.y * vz - q.z * vy);
    const L y = 2.0 * (q.z * vx - q.x * vz);
    const L z = 2.0 * (q.x * vy - q.y * vx);
    store<L>(world.x, i, load<L>(origin.x, i) + (vx + q.w * x + (q.y * z - q.z * y)));
    store<L>(world.y, i, load<L>(origin.y, i) + (vy + q.w * y + (q.z * x - q.x * z)));
    store<L>(world.z, i, load<L>(origin.z, i) + (vz + q.w * z + (q.x * y - q.y * x)));
  }
}

template <class L, class Bits>
inline constexpr BlockKernels kKernels = {find_half_turns<L, Bits>, turn<L>, place<L>};

}  // namespace marey::block_kernels_detail
