#pragma once

#include <cstdint>

namespace marey {

/// A few doubles that are computed with at once: one 128-bit SIMD register, native or wasm. + - * and [] work per lane.
using Lanes = double __attribute__((vector_size(16)));
/// The bits of Lanes.
using LaneBits = std::uint64_t __attribute__((vector_size(16)));

inline constexpr int kLaneCount = static_cast<int>(sizeof(Lanes) / sizeof(double));

/// Twice as many, for code that is compiled for processors with registers of 256 bits.
using WideLanes = double __attribute__((vector_size(32)));
using WideLaneBits = std::uint64_t __attribute__((vector_size(32)));

}  // namespace marey
