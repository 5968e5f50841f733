#pragma once

#include <array>

#include "core/math/axis.h"

namespace marey {

inline constexpr int kMostBlockFrames = 64;

/// A quantity over the frames of a block.
using BlockColumn = std::array<double, kMostBlockFrames>;

struct PositionColumns {
  BlockColumn x, y, z;
};

struct QuaternionColumns {
  BlockColumn w, x, y, z;
};

/// The arithmetic of FrameBlock, from column to column; entries from `count` on come out meaningless, and may be read.
/// The same source for registers of 128 and 256 bits (block_kernel_templates.h), with the same bits as the result.
struct BlockKernels {
  /// Sines and cosines of half of `count` angles in degrees.
  void (*find_half_turns)(const double* angles_deg, int count, BlockColumn& sines, BlockColumn& cosines);
  /// `to` = `from` turned about one of its own axes by the angles of which these are halves. `to` may be `from`.
  void (*turn)(Axis axis, const BlockColumn& half_sines, const BlockColumn& half_cosines, const QuaternionColumns& from, int count,
               QuaternionColumns& to);
  /// `world` = `origin` + `local` turned by `rotation`.
  void (*place)(const QuaternionColumns& rotation, const PositionColumns& origin, const PositionColumns& local, int count,
                PositionColumns& world);
};

/// Those for the processor that this runs on.
[[nodiscard]] const BlockKernels& block_kernels();

namespace block_kernels_detail {
/// For processors with AVX2; null in programs for others.
[[nodiscard]] const BlockKernels* avx2();
}  // namespace block_kernels_detail

}  // namespace marey
