#include "core/lint/floor_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/kinematics/frame_block.h"
#include "core/lint/curve_steps.h"
#include "core/lint/incidents.h"
#include "core/lint/wording.h"

namespace marey {
namespace {

// Shares of the stature. A foot that rolls from heel to toe moves its lowest joint by about 2 %.
constexpr double kFloorBand = 0.03;
// 7 cm of a person: more than soft floors, soles and the size of the foot explain.
constexpr double kLeastDepth = 0.04;
// A figure whose lowest end is in the band for fewer of its frames does not stand on a floor.
constexpr double kLeastStandingShare = 0.6;
// Of the standing frames, so many are lower than the floor.
constexpr double kFloorPercentile = 0.1;
constexpr double kGap_s = 0.1;

/// The lowest node of a frame.
struct LowestEnd {
  double height = HUGE_VAL;
  NodeIndex node = 0;
};

std::vector<LowestEnd> compute_lowest_ends(const Clip& clip, FrameRange frames) {
  std::vector<LowestEnd> lowest(idx(frames.count));
  FrameBlock block(clip.skeleton, clip.motion, clip.settings.position_rule);
  for (int first = 0; first < frames.count; first += FrameBlock::kMaxFrames) {
    const int count = std::min(FrameBlock::kMaxFrames, frames.count - first);
    block.compute({frames.first + first, count}, [&](NodeIndex node, const FrameBlock::Positions& positions) {
      const FrameBlock::Column& heights = clip.settings.up_axis == Axis::Z   ? positions.z
                                          : clip.settings.up_axis == Axis::Y ? positions.y
                                                                             : positions.x;
      for (int i = 0; i < count; ++i) {
        LowestEnd& end = lowest[idx(first + i)];
        if (heights[idx(i)] < end.height) end = {heights[idx(i)], node};
      }
    });
  }
  return lowest;
}

/// The height that the figure stands on in most frames; nothing if it does not. What hangs from its root, or is carried by
/// it, has the root as its lowest node and does not stand.
std::optional<double> find_floor(const Skeleton& skeleton, const std::vector<LowestEnd>& lowest, double stature) {
  std::vector<double> heights;
  heights.reserve(lowest.size());
  for (const LowestEnd& end : lowest) {
    if (std::isfinite(end.height) && skeleton.node(end.node).parent != kNoParent) heights.push_back(end.height);
  }
  if (size_of(heights) < lint::kLeastFrames) return std::nullopt;
  std::sort(heights.begin(), heights.end());
  const double middle = heights[heights.size() / 2];
  const auto begin = std::lower_bound(heights.begin(), heights.end(), middle - kFloorBand * stature);
  const auto end = std::upper_bound(heights.begin(), heights.end(), middle + kFloorBand * stature);
  const auto standing = static_cast<double>(end - begin);
  if (standing < kLeastStandingShare * static_cast<double>(lowest.size())) return std::nullopt;
  return *(begin + static_cast<std::ptrdiff_t>(kFloorPercentile * standing));
}

/// A stretch below the floor.
struct Dip {
  FrameRange frames;
  double depth = 0.0;
  NodeIndex node = 0;
};

std::vector<Dip> find_dips(const std::vector<LowestEnd>& lowest, FrameRange frames, double floor, double least, int gap) {
  std::vector<Dip> dips;
  for (int i = 0; i < frames.count; ++i) {
    const LowestEnd& end = lowest[idx(i)];
    const double depth = floor - end.height;
    if (!(depth > least) || !std::isfinite(depth)) continue;
    const FrameIndex frame = frames.first + i;
    if (dips.empty() || frame > dips.back().frames.end() + gap) dips.push_back({{frame, 1}, 0.0, 0});
    Dip& dip = dips.back();
    dip.frames.count = frame - dip.frames.first + 1;
    if (depth > dip.depth) dip = {dip.frames, depth, end.node};
  }
  return dips;
}

}  // namespace

void add_floor_findings(const Clip& clip, FrameRange frames, const LintOptions& options, LintReport& report) {
  constexpr auto kKind = FindingKind::BelowFloor;
  const double stature = compute_stature(clip.skeleton);
  if (!(stature > 0.0) || frames.count < lint::kLeastFrames) return;
  const std::vector<LowestEnd> lowest = compute_lowest_ends(clip, frames);
  const std::optional<double> floor = find_floor(clip.skeleton, lowest, stature);
  if (!floor) return;
  const int gap = lint::frames_in(clip.motion, kGap_s, 1);
  std::vector<Dip> dips = find_dips(lowest, frames, *floor, kLeastDepth * stature, gap);
  report.left_out[static_cast<std::size_t>(kKind)] =
      lint::keep_worst(dips, options.most_per_kind, [](const Dip& dip) { return dip.depth; });
  for (const Dip& dip : dips) {
    report.findings.push_back(
        {kKind, clip.skeleton.node(dip.node).joint, std::nullopt, dip.frames, dip.frames.count,
         fmt::format("{} is up to {}, {} % of the stature, below the floor at height {} in {}.",
                     lint::quoted(node_label(clip.skeleton, dip.node)),
                     lint::length_text(dip.depth, options.metres_per_unit), lint::rounded(100.0 * dip.depth / stature),
                     lint::rounded(*floor), lint::frames_text(dip.frames))});
  }
}

}  // namespace marey
