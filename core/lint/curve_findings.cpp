#include "core/lint/curve_findings.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "core/base/counted.h"
#include "core/lint/curve_steps.h"
#include "core/lint/incidents.h"
#include "core/lint/wording.h"

namespace marey {
namespace {

// Of a jump or a spike. Smaller ones are hard to see, and quick movements at low frame rates have as much.
constexpr double kLeastAngle_deg = 12.0;
constexpr double kLeastShareOfStature = 0.04;
// As a multiple of the channel's usual change from step to step. Noise of the normal distribution stays below 4 of them.
constexpr double kLeastUsualChanges = 20.0;
// As a multiple of the steps around. The quickest limbs speed up over several frames, so their steps come in company.
constexpr double kLeastNeighbourSteps = 6.0;
// A step has no company if those beside it are smaller than this part of it.
constexpr double kMostOfAdjacentStep = 0.3;
// Nor if no step nearby reaches this part of it, but for one that leads back by as much.
constexpr double kMostOfNearbyStep = 0.33;
constexpr double kLeastOfReturn = 0.7;
// Of the leap of an angle, the joint must turn by so much; else it is the angles that leap, not the pose.
constexpr double kLeastShareOfTurn = 0.4;
// A clip in which so many frames stand alone is a list of poses.
constexpr double kMostShareOfSpikes = 0.2;
// What is less apart in time is one event.
constexpr double kGap_s = 0.1;

class CurveScan {
 public:
  CurveScan(const Clip& clip, FrameRange frames) : clip_(clip), frames_(frames), stature_(compute_stature(clip.skeleton)) {}

  void scan(ChannelIndex channel) {
    const Channel& what = clip_.skeleton.channel(channel);
    const bool moves = is_position(what.kind) && stature_ > 0.0;
    if (!moves && !is_rotation(what.kind)) return;
    floor_ = moves ? kLeastShareOfStature * stature_ : kLeastAngle_deg;
    steps_.load(clip_, channel, frames_);
    least_ = std::max(floor_, kLeastUsualChanges * steps_.compute_usual_change());
    const auto steps = steps_.values();
    for (int i = 0; i < size_of(steps); ++i) {
      if (std::abs(steps[idx(i)]) < 0.5 * floor_) continue;
      if (is_spike(i)) {
        add(spikes, channel, i, 1);
        ++i;
      } else if (is_jump(i)) {
        add(jumps, channel, i, 2);
      }
    }
  }

  std::vector<lint::Incident> jumps;
  std::vector<lint::Incident> spikes;

 private:
  [[nodiscard]] double step(int i) const {
    const auto steps = steps_.values();
    return i >= 0 && i < size_of(steps) ? steps[idx(i)] : 0.0;
  }

  /// Step i leads to a frame apart from both of its neighbours, which agree.
  [[nodiscard]] bool is_spike(int i) {
    if (i + 1 >= size_of(steps_.values())) return false;
    const double height = 0.5 * std::abs(step(i) - step(i + 1));
    if (!(height >= least_) || step(i) * step(i + 1) >= 0.0) return false;
    if (std::abs(step(i) + step(i + 1)) > kMostOfAdjacentStep * height) return false;
    const double around = std::max(std::abs(step(i - 1)), std::abs(step(i + 2)));
    return around <= kMostOfAdjacentStep * height && height >= kLeastNeighbourSteps * steps_.compute_neighbour_step(i, 2);
  }

  [[nodiscard]] bool is_jump(int i) {
    const double size = std::abs(step(i));
    if (!(size >= least_)) return false;
    const double around = std::max(std::abs(step(i - 1)), std::abs(step(i + 1)));
    if (around > kMostOfAdjacentStep * size || size < kLeastNeighbourSteps * steps_.compute_neighbour_step(i, 1)) return false;
    return !has_company(i);
  }

  [[nodiscard]] bool has_company(int i) const {
    int returns = 0;
    for (int other = i - lint::CurveSteps::kNeighbours; other <= i + lint::CurveSteps::kNeighbours; ++other) {
      const double share = step(other) / step(i);
      if (other == i || std::abs(share) < kMostOfNearbyStep) continue;
      if (share > -kLeastOfReturn || ++returns > 1) return true;
    }
    return false;
  }

  /// Angles may leap while the joint does not; then nothing is seen.
  void add(std::vector<lint::Incident>& incidents, ChannelIndex channel, int i, int frame_count) {
    const Channel& what = clip_.skeleton.channel(channel);
    const FrameIndex frame = frames_.first + i;
    const double least_turn = std::max(floor_, kLeastShareOfTurn * std::abs(step(i)));
    if (is_rotation(what.kind) && lint::turn_between_deg(clip_, what.joint, frame, frame + 1) < least_turn) return;
    const FrameIndex first = frame_count == 1 ? frame + 1 : frame;
    incidents.push_back({{first, frame_count}, channel, std::abs(step(i)), std::abs(step(i)) / floor_});
  }

  const Clip& clip_;
  FrameRange frames_;
  double stature_;
  double floor_ = 0.0;
  double least_ = 0.0;
  lint::CurveSteps steps_;
};

std::string place_of(const lint::Incident& worst) {
  return worst.frames.count == 1 ? fmt::format("in frame {} alone", worst.frames.first + 1)
                                 : fmt::format("between frames {} and {}", worst.frames.first + 1, worst.frames.end());
}

std::string sentence_about(const Clip& clip, const lint::IncidentGroup& group, std::string_view verb,
                           const LintOptions& options) {
  const lint::Incident& worst = group.worst;
  const std::string amount =
      lint::amount_text(clip.skeleton.channel(worst.channel), worst.size, options.metres_per_unit);
  const std::string text = fmt::format("{} {} by {} {}", lint::quoted(channel_label(clip.skeleton, worst.channel)), verb,
                                       amount, place_of(worst));
  const std::string others =
      group.channels > 1 ? fmt::format(", and {} about then", counted(group.channels - 1, "other channel")) : "";
  return group.times > 1 ? fmt::format("{}{}: {} times in {}.", text, others, group.times, lint::frames_text(group.frames))
                         : text + others + ".";
}

int count_times(const std::vector<lint::IncidentGroup>& groups) {
  return std::accumulate(groups.begin(), groups.end(), 0, [](int sum, const auto& group) { return sum + group.times; });
}

void add_incidents(FindingKind kind, std::string_view verb, const Clip& clip, std::vector<lint::IncidentGroup> groups,
                   const LintOptions& options, LintReport& report) {
  report.left_out[static_cast<std::size_t>(kind)] =
      lint::keep_worst(groups, options.most_per_kind, [](const lint::IncidentGroup& g) { return g.worst.weight; });
  for (const lint::IncidentGroup& group : groups) {
    const JointIndex joint = clip.skeleton.channel(group.worst.channel).joint;
    report.findings.push_back({kind, joint, group.worst.channel, group.frames, group.channels,
                               sentence_about(clip, group, verb, options)});
  }
}

}  // namespace

void add_curve_findings(const Clip& clip, FrameRange frames, const LintOptions& options, LintReport& report) {
  if (!lint::is_recording(clip.motion)) return;
  CurveScan scan(clip, frames);
  for (ChannelIndex channel = 0; channel < clip.skeleton.channel_count(); ++channel) scan.scan(channel);
  const int gap = lint::frames_in(clip.motion, kGap_s, 1);
  std::vector<lint::IncidentGroup> jumps = lint::grouped(std::move(scan.jumps), gap);
  std::vector<lint::IncidentGroup> spikes = lint::grouped(std::move(scan.spikes), gap);
  if (count_times(spikes) > std::max(1.0, kMostShareOfSpikes * frames.count)) return;
  add_incidents(FindingKind::Jump, "jumps", clip, std::move(jumps), options, report);
  add_incidents(FindingKind::Spike, "leaves its curve", clip, std::move(spikes), options, report);
}

}  // namespace marey
