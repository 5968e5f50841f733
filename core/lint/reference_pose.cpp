#include "core/lint/reference_pose.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/lint/curve_steps.h"
#include "core/lint/wording.h"

namespace marey {
namespace {

constexpr int kLeastFrames = 4;
// Mean over all rotation channels. From a T pose to standing the arms alone give about 3 degrees.
constexpr double kLeastFirstStep_deg = 2.5;
// The first step beside the usual one, and beside those of the quickest movements; of a hundred others one may be larger,
// as recordings have flaws.
constexpr double kLeastUsualSteps = 6.0;
constexpr double kLeastQuickSteps = 2.5;
constexpr double kQuickPercentile = 0.99;

/// Mean absolute step of all rotation channels, whole turns taken off; empty without such channels.
std::vector<double> compute_mean_steps(const Clip& clip) {
  std::vector<double> means;
  lint::CurveSteps steps;
  int channels = 0;
  for (ChannelIndex channel = 0; channel < clip.skeleton.channel_count(); ++channel) {
    if (!is_rotation(clip.skeleton.channel(channel).kind)) continue;
    steps.load(clip, channel, {0, clip.motion.frame_count()});
    means.resize(steps.values().size());
    for (std::size_t i = 0; i < means.size(); ++i) means[i] += std::abs(steps.values()[i]);
    ++channels;
  }
  for (double& mean : means) mean /= channels;
  return means;
}

/// `part` 0 gives the least, 1 the greatest. Reorders `values`, which are not empty.
double percentile_of(std::vector<double>& values, double part) {
  const auto rank = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

bool is_rest_pose(const Clip& clip) {
  for (ChannelIndex channel = 0; channel < clip.skeleton.channel_count(); ++channel) {
    if (is_rotation(clip.skeleton.channel(channel).kind) && clip.motion.sample(channel, 0) != 0.0) return false;
  }
  return true;
}

}  // namespace

bool add_reference_pose(const Clip& clip, LintReport& report) {
  if (clip.motion.frame_count() < kLeastFrames) return false;
  std::vector<double> steps = compute_mean_steps(clip);
  if (steps.empty()) return false;
  const double first = steps.front();
  steps.erase(steps.begin());
  const double usual = percentile_of(steps, 0.5);
  const double quick = percentile_of(steps, kQuickPercentile);
  if (first < kLeastFirstStep_deg || first < kLeastUsualSteps * usual || first < kLeastQuickSteps * quick) return false;
  report.findings.push_back(
      {FindingKind::ReferencePose, std::nullopt, std::nullopt, FrameRange{0, 1}, 1,
       fmt::format("Frame 1 is a pose of its own{}: the angles change by {} degrees on average to frame 2, and by {} from "
                   "frame to frame afterwards.",
                   is_rest_pose(clip) ? ", with all angles 0" : "", lint::rounded(first), lint::rounded(usual))});
  return true;
}

}  // namespace marey
