#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/lint/finding.h"
#include "core/motion/clip.h"

namespace marey {

struct LintOptions {
  /// Findings of one kind about places in time: the worst so many are kept, the others counted. >= 1.
  int most_per_kind = 10;
  /// Metres per file unit where somebody has said so; lengths are then told in metres too. A guess does not count.
  std::optional<double> metres_per_unit;
};

struct LintReport {
  /// In the order of the kinds, within a kind by frame, then by joint. The same clip always gives the same list.
  std::vector<Finding> findings;
  std::array<int, kFindingKindCount> left_out{};  ///< by kind: findings beyond LintOptions::most_per_kind
};

/// Looks through a clip for what is legal but seldom meant: names, tree and channels that other programs stumble over;
/// curves that jump, flip or stand still; ends of the figure below the floor it stands on. Time grows linearly with the
/// number of samples; memory beside the report with the number of frames and of findings. Samples that are not finite
/// are passed over.
[[nodiscard]] LintReport lint_clip(const Clip& clip, const LintOptions& options = {});

}  // namespace marey
