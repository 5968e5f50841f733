#include "core/lint/freeze_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "core/base/counted.h"
#include "core/lint/curve_steps.h"
#include "core/lint/incidents.h"
#include "core/lint/wording.h"

namespace marey {
namespace {

// A body that is measured never keeps so still: its numbers change in the last decimal at least.
constexpr double kLeastDuration_s = 0.5;
// At low rates half a second is nothing; this many equal steps are not chance.
constexpr int kLeastFrames = 8;
// Of the steps elsewhere, so many change the value; curves with few decimals or keys rest by nature.
constexpr double kLeastLivelyShare = 0.9;
// Of the clip; what moves for a shorter time rests by nature too.
constexpr double kLeastMovingShare = 0.3;
// The usual step of a moving curve, as a multiple of its smallest one: otherwise the last decimal hides slow movements.
constexpr double kLeastResolution = 10.0;
// The step before or behind a freeze, as a share of the usual one: a rest that is meant is entered and left slowly.
constexpr double kLeastAbruptShare = 0.5;

/// Channels that keep their values over the same frames.
struct Freeze {
  FrameRange frames;
  ChannelIndex channel = 0;
  int channels = 1;
};

/// Runs of at least `least` frames in which still(i), the step from frame i to the next, holds.
template <class Still>
std::vector<FrameRange> find_runs(int frame_count, int least, Still still) {
  std::vector<FrameRange> runs;
  for (FrameIndex frame = 0; frame + 1 < frame_count;) {
    const FrameIndex first = frame;
    while (frame + 1 < frame_count && still(frame)) ++frame;
    if (frame - first + 1 >= least) runs.push_back({first, frame - first + 1});
    if (frame == first) ++frame;
  }
  return runs;
}

bool is_within(const FrameRange& inner, const std::vector<FrameRange>& outer) {
  const auto behind = std::upper_bound(outer.begin(), outer.end(), inner.first,
                                       [](FrameIndex first, const FrameRange& range) { return first < range.first; });
  return behind != outer.begin() && inner.end() <= std::prev(behind)->end();
}

class FreezeScan {
 public:
  explicit FreezeScan(const Clip& clip)
      : clip_(clip),
        least_(lint::frames_in(clip.motion, kLeastDuration_s, kLeastFrames)),
        any_changes_(idx(clip.motion.frame_count())) {}

  void mark_changes(ChannelIndex channel) {
    const auto samples = clip_.motion.channel_samples(channel);
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      if (samples[i] != samples[i + 1]) any_changes_[i] = true;
    }
  }

  void find_figure_freezes() {
    const bool moves = std::any_of(any_changes_.begin(), any_changes_.end(), [](bool changes) { return changes; });
    if (!moves) return;
    figure = find_runs(clip_.motion.frame_count(), least_, [&](FrameIndex i) { return !any_changes_[idx(i)]; });
  }

  void scan(ChannelIndex channel) {
    const auto samples = clip_.motion.channel_samples(channel);
    const auto still = [&](FrameIndex i) { return samples[idx(i)] == samples[idx(i) + 1]; };
    const std::vector<FrameRange> runs = find_runs(size_of(samples), least_, still);
    if (runs.empty() || !is_lively(samples, runs)) return;
    const double least_step = kLeastAbruptShare * usual_step_;
    for (const FrameRange& run : runs) {
      const bool begins_abruptly = run.first > 0 && std::abs(step(samples, run.first - 1)) >= least_step;
      const bool ends_abruptly = run.end() < size_of(samples) && std::abs(step(samples, run.end() - 1)) >= least_step;
      if ((begins_abruptly || ends_abruptly) && !is_within(run, figure)) channels.push_back({run, channel, 1});
    }
  }

  std::vector<FrameRange> figure;
  std::vector<Freeze> channels;

 private:
  static double step(std::span<const double> samples, FrameIndex frame) {
    return samples[idx(frame) + 1] - samples[idx(frame)];
  }

  /// True if the curve changes with nearly every step outside of `runs`, over long enough a time and by more than its last
  /// decimal. Computes the usual step.
  [[nodiscard]] bool is_lively(std::span<const double> samples, const std::vector<FrameRange>& runs) {
    int moving = size_of(samples) - 1;
    for (const FrameRange& run : runs) moving -= run.count - 1;
    changes_.clear();
    for (FrameIndex frame = 0; frame + 1 < size_of(samples); ++frame) {
      const double change = std::abs(step(samples, frame));
      if (change > 0.0) changes_.push_back(change);
    }
    if (moving < std::max<double>(least_, kLeastMovingShare * size_of(samples))) return false;
    if (size_of(changes_) < kLeastLivelyShare * moving) return false;
    const auto middle = changes_.begin() + static_cast<std::ptrdiff_t>(changes_.size() / 2);
    std::nth_element(changes_.begin(), middle, changes_.end());
    usual_step_ = *middle;
    return usual_step_ >= kLeastResolution * *std::min_element(changes_.begin(), middle + 1);
  }

  const Clip& clip_;
  int least_;
  std::vector<bool> any_changes_;
  std::vector<double> changes_;
  double usual_step_ = 0.0;
};

/// Freezes of the same frames become one; sorted by frames, then channel.
std::vector<Freeze> merged(std::vector<Freeze> freezes) {
  std::sort(freezes.begin(), freezes.end(), [](const Freeze& a, const Freeze& b) {
    return std::tuple(a.frames.first, a.frames.count, a.channel) < std::tuple(b.frames.first, b.frames.count, b.channel);
  });
  std::vector<Freeze> result;
  for (const Freeze& freeze : freezes) {
    if (!result.empty() && result.back().frames == freeze.frames) {
      ++result.back().channels;
    } else {
      result.push_back(freeze);
    }
  }
  return result;
}

void add_figure(const Clip& clip, std::vector<FrameRange> runs, const LintOptions& options, LintReport& report) {
  constexpr auto kKind = FindingKind::FrozenFigure;
  report.left_out[static_cast<std::size_t>(kKind)] =
      lint::keep_worst(runs, options.most_per_kind, [](const FrameRange& run) { return run.count; });
  for (const FrameRange& run : runs) {
    report.findings.push_back({kKind, std::nullopt, std::nullopt, run, run.count,
                               fmt::format("Nothing moves in {}, {} s.", lint::frames_text(run),
                                           lint::rounded((run.count - 1) * clip.motion.frame_time_s()))});
  }
}

void add_channels(const Clip& clip, std::vector<Freeze> freezes, const LintOptions& options, LintReport& report) {
  constexpr auto kKind = FindingKind::FrozenChannel;
  report.left_out[static_cast<std::size_t>(kKind)] =
      lint::keep_worst(freezes, options.most_per_kind, [](const Freeze& freeze) {
        return static_cast<double>(freeze.channels) * freeze.frames.count;
      });
  for (const Freeze& freeze : freezes) {
    const std::string others =
        freeze.channels > 1 ? fmt::format(" keeps its value, with {},", counted(freeze.channels - 1, "other channel"))
                            : fmt::format(" stays at {}", clip.motion.sample(freeze.channel, freeze.frames.first) + 0.0);
    report.findings.push_back(
        {kKind, clip.skeleton.channel(freeze.channel).joint, freeze.channel, freeze.frames, freeze.channels,
         fmt::format("{}{} in {}, but changes from frame to frame elsewhere.",
                     lint::quoted(channel_label(clip.skeleton, freeze.channel)), others,
                     lint::frames_text(freeze.frames))});
  }
}

}  // namespace

void add_freeze_findings(const Clip& clip, const LintOptions& options, LintReport& report) {
  if (!lint::is_recording(clip.motion)) return;
  FreezeScan scan(clip);
  for (ChannelIndex channel = 0; channel < clip.skeleton.channel_count(); ++channel) scan.mark_changes(channel);
  scan.find_figure_freezes();
  for (ChannelIndex channel = 0; channel < clip.skeleton.channel_count(); ++channel) scan.scan(channel);
  add_figure(clip, std::move(scan.figure), options, report);
  add_channels(clip, merged(std::move(scan.channels)), options, report);
}

}  // namespace marey
