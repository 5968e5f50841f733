#pragma once

#include <string>
#include <vector>

#include "core/lint/lint.h"
#include "tests/core/kinematics/figures.h"

namespace marey::test {

inline constexpr double kFrameTime_s = 1.0 / 60.0;

/// A root "Hips" (xyzZXY) with a leg "Knee" and "Foot" (ZXY) of 45 units each and an End Site 5 units ahead of the foot;
/// 95 units tall from the chest's End Site to the foot. Up is y.
[[nodiscard]] Skeleton make_walker();

/// The walker standing on the floor at 0 and moving gently, each angle at a rate of its own.
[[nodiscard]] Clip make_moving_walker(int frame_count);

[[nodiscard]] ChannelIndex find_channel(const Clip& clip, const std::string& label);
[[nodiscard]] std::span<double> samples_of(Clip& clip, const std::string& label);

/// A clip of this figure without frames, for findings about the tree.
[[nodiscard]] Clip make_still(const std::vector<figures::JointPlan>& joints);

/// Ids of the findings in their order, with blanks between.
[[nodiscard]] std::string kinds_of(const LintReport& report);

/// The finding of this kind; the test fails unless there is exactly one.
[[nodiscard]] Finding the_finding(const LintReport& report, FindingKind kind);

}  // namespace marey::test
