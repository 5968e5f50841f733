#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/bvh/style.h"
#include "core/motion/motion.h"

namespace marey {

enum class LineEnd : std::uint8_t { Lf, CrLf };

/// In what a saved file is wanted to differ from the style of the opened one. The defaults ask for nothing.
struct SaveOptions {
  FrameRange frames{};            ///< lies within the motion; count 0: all
  std::optional<int> decimals{};  ///< of samples and offsets, 0 to kMostSavedDecimals; nothing: as they are, exactly
  std::optional<LineEnd> line_end{};
  friend bool operator==(const SaveOptions&, const SaveOptions&) = default;
};

inline constexpr int kMostSavedDecimals = 15;

/// Writes a BVH file as write_bvh() does, but for what `options` ask. With decimals, each number is the nearest one that
/// has so many (halves to even, -0 as 0), and all are written with just so many; the frame time stays.
[[nodiscard]] std::string write_bvh(const Skeleton& skeleton, const Motion& motion, const BvhStyle& style,
                                    const SaveOptions& options);

/// What rounding to decimals does to a clip's samples and offsets.
struct RoundingCost {
  std::int64_t numbers = 0;  ///< that change by more than a binary fraction can help
  double largest = 0.0;      ///< change, degrees or file units
};

/// Looks at each number of `frames` (all if it is empty). Good enough to tell people: the error of the arithmetic, some
/// 1e-16 of the number, counts as no change.
[[nodiscard]] RoundingCost measure_rounding(const Skeleton& skeleton, const Motion& motion, FrameRange frames, int decimals);

}  // namespace marey
