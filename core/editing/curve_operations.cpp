#include "core/editing/curve_operations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <string_view>
#include <utility>

#include "core/signal/gaussian_smoothing.h"

namespace marey {
namespace {

std::vector<SampleRun> find_runs_within(const Clip& clip, const SampleSelection& selection) {
  std::vector<SampleRun> runs;
  for (const SampleRun& run : selection.runs()) {
    if (run.channel < 0 || run.channel >= clip.motion.channel_count()) continue;
    const FrameIndex first = std::max(run.frames.first, 0);
    const FrameIndex end = std::min(run.frames.end(), clip.motion.frame_count());
    if (first < end) runs.push_back({run.channel, {first, end - first}});
  }
  return runs;
}

int count_channels(std::span<const SampleRun> runs) {
  int count = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) count += i == 0 || runs[i].channel != runs[i - 1].channel ? 1 : 0;
  return count;
}

// "12 samples of LeftElbow Zrotation", "12 samples in 3 channels".
std::string describe_samples(const Clip& clip, std::span<const SampleRun> runs) {
  std::int64_t samples = 0;
  for (const SampleRun& run : runs) samples += run.frames.count;
  const int channels = count_channels(runs);
  if (channels > 1) return fmt::format("{} samples in {} channels", samples, channels);
  const std::string label = runs.empty() ? std::string() : channel_label(clip.skeleton, runs[0].channel);
  return fmt::format("{} sample{} of {}", samples, samples == 1 ? "" : "s", label);
}

// "LeftElbow Zrotation", "3 channels".
std::string describe_channels(const Clip& clip, std::span<const SampleRun> runs) {
  const int channels = count_channels(runs);
  return channels == 1 ? channel_label(clip.skeleton, runs[0].channel) : fmt::format("{} channels", channels);
}

std::span<const double> samples_of(const Clip& clip, ChannelIndex channel, FrameRange frames) {
  return clip.motion.channel_samples(channel).subspan(idx(frames.first), idx(frames.count));
}

// An edit that replaces each selected sample v by new_value(v).
template <class NewValue>
Edit make_mapped_edit(const Clip& clip, const SampleSelection& selection, std::string_view verb, NewValue new_value) {
  const std::vector<SampleRun> runs = find_runs_within(clip, selection);
  Edit edit;
  edit.name = fmt::format("{} {}", verb, describe_samples(clip, runs));
  for (const SampleRun& run : runs) {
    const std::span<const double> before = samples_of(clip, run.channel, run.frames);
    SamplesChange change{run.channel, run.frames.first, std::vector<double>(before.size())};
    std::transform(before.begin(), before.end(), change.values.begin(), new_value);
    edit.samples.push_back(std::move(change));
  }
  return edit;
}

// Largest distance in whole frames at which the falloff still weighs something.
int falloff_reach(const Falloff& falloff, int frame_count) {
  if (!std::isfinite(falloff.radius_frames) || falloff.radius_frames <= 1.0) return 0;
  return static_cast<int>(std::min(std::ceil(falloff.radius_frames) - 1.0, static_cast<double>(frame_count)));
}

FrameRange widened(FrameRange frames, int reach, int frame_count) {
  const FrameIndex first = std::max(frames.first - reach, 0);
  const std::int64_t end = std::min<std::int64_t>(std::int64_t{frames.end()} + reach, frame_count);
  return {first, static_cast<int>(end) - first};
}

// Distance of each frame of `frames` to the nearest frame of `runs`, which lie within, by one pass in each direction.
std::vector<int> compute_distances(FrameRange frames, std::span<const SampleRun> runs) {
  std::vector<int> distances(idx(frames.count), std::numeric_limits<int>::max() - 1);
  for (const SampleRun& run : runs) {
    std::fill_n(distances.begin() + (run.frames.first - frames.first), run.frames.count, 0);
  }
  for (std::size_t i = 1; i < distances.size(); ++i) distances[i] = std::min(distances[i], distances[i - 1] + 1);
  for (std::size_t i = distances.size(); i-- > 1;) distances[i - 1] = std::min(distances[i - 1], distances[i] + 1);
  return distances;
}

SamplesChange make_moved(const Clip& clip, FrameRange frames, std::span<const SampleRun> runs, double delta,
                         const Falloff& falloff) {
  const ChannelIndex channel = runs[0].channel;
  const std::span<const double> before = samples_of(clip, channel, frames);
  const std::vector<int> distances = compute_distances(frames, runs);
  SamplesChange change{channel, frames.first, {before.begin(), before.end()}};
  for (std::size_t i = 0; i < change.values.size(); ++i) {
    if (std::isfinite(before[i])) change.values[i] += delta * falloff_weight(falloff, distances[i]);
  }
  return change;
}

}  // namespace

double falloff_weight(const Falloff& falloff, double distance_frames) {
  if (distance_frames <= 0.0) return 1.0;
  if (!std::isfinite(falloff.radius_frames) || distance_frames >= falloff.radius_frames) return 0.0;
  return 0.5 * (1.0 + std::cos(std::numbers::pi * distance_frames / falloff.radius_frames));
}

Edit make_move_edit(const Clip& clip, const SampleSelection& selection, double delta, Falloff falloff) {
  const std::vector<SampleRun> runs = find_runs_within(clip, selection);
  const int frame_count = clip.motion.frame_count();
  const int reach = falloff_reach(falloff, frame_count);
  Edit edit;
  edit.name = fmt::format("Move {}", describe_samples(clip, runs));
  for (std::size_t begin = 0, end = 0; begin < runs.size(); begin = end) {
    // Runs that pull at the same frames are moved together.
    FrameRange touched = widened(runs[begin].frames, reach, frame_count);
    for (end = begin + 1; end < runs.size() && runs[end].channel == runs[begin].channel; ++end) {
      const FrameRange next = widened(runs[end].frames, reach, frame_count);
      if (next.first >= touched.end()) break;
      touched = hull(touched, next);
    }
    const std::span<const SampleRun> together = std::span(runs).subspan(begin, end - begin);
    edit.samples.push_back(make_moved(clip, touched, together, delta, falloff));
  }
  return edit;
}

Edit make_value_edit(const Clip& clip, const SampleSelection& selection, double value) {
  return make_mapped_edit(clip, selection, "Set", [=](double) { return value; });
}

double scaled_about(double pivot, double factor, double value) {
  // A factor of 1 keeps the bits, which the formula would round.
  const bool stays = factor == 1.0 || !std::isfinite(value);
  return stays ? value : pivot + factor * (value - pivot);
}

Edit make_scale_edit(const Clip& clip, const SampleSelection& selection, double factor, double pivot) {
  return make_mapped_edit(clip, selection, "Scale", [=](double before) { return scaled_about(pivot, factor, before); });
}

Edit make_smooth_edit(const Clip& clip, const SampleSelection& selection, double sigma_frames) {
  if (!std::isfinite(sigma_frames) || sigma_frames <= 0.0) return {};
  const std::vector<SampleRun> runs = find_runs_within(clip, selection);
  Edit edit;
  edit.name = fmt::format("Smooth {}", describe_channels(clip, runs));
  for (const SampleRun& run : runs) {
    SamplesChange change{run.channel, run.frames.first, std::vector<double>(idx(run.frames.count))};
    compute_gaussian_smoothed(clip.motion.channel_samples(run.channel), run.frames, sigma_frames, change.values);
    edit.samples.push_back(std::move(change));
  }
  return edit;
}

Edit make_sample_edit(const Clip& clip, ChannelIndex channel, FrameIndex frame, double value) {
  const bool exists = channel >= 0 && channel < clip.motion.channel_count();
  Edit edit;
  edit.name = exists ? fmt::format("Set {} at frame {}", channel_label(clip.skeleton, channel), std::int64_t{frame} + 1)
                     : "Set sample";
  edit.samples.push_back({channel, frame, {value}});
  return edit;
}

double compute_selection_mean(const Clip& clip, const SampleSelection& selection) {
  double sum = 0.0;
  std::int64_t count = 0;
  for (const SampleRun& run : find_runs_within(clip, selection)) {
    for (const double value : samples_of(clip, run.channel, run.frames)) {
      if (!std::isfinite(value)) continue;
      sum += value;
      ++count;
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

}  // namespace marey
