#include "core/editing/sample_selection.h"

#include <algorithm>

namespace marey {
namespace {

// First run that ends at `frame` of `channel` or behind it.
auto find_run_ending_from(const std::vector<SampleRun>& runs, ChannelIndex channel, FrameIndex frame) {
  return std::partition_point(runs.begin(), runs.end(), [&](const SampleRun& run) {
    return run.channel < channel || (run.channel == channel && run.frames.end() < frame);
  });
}

FrameRange range_between(FrameIndex first, FrameIndex end) { return {first, end - first}; }

}  // namespace

void SampleSelection::add(ChannelIndex channel, FrameRange frames) {
  if (frames.count <= 0) return;
  FrameIndex first = frames.first;
  FrameIndex end = frames.end();
  const auto begin = find_run_ending_from(runs_, channel, first);
  auto behind = begin;
  for (; behind != runs_.end() && behind->channel == channel && behind->frames.first <= end; ++behind) {
    first = std::min(first, behind->frames.first);
    end = std::max(end, behind->frames.end());
  }
  runs_.insert(runs_.erase(begin, behind), {channel, range_between(first, end)});
}

void SampleSelection::remove(ChannelIndex channel, FrameRange frames) {
  if (frames.count <= 0) return;
  const auto begin = find_run_ending_from(runs_, channel, frames.first);
  std::vector<SampleRun> rest;
  auto behind = begin;
  for (; behind != runs_.end() && behind->channel == channel && behind->frames.first < frames.end(); ++behind) {
    const FrameRange left = range_between(behind->frames.first, std::min(behind->frames.end(), frames.first));
    const FrameRange right = range_between(std::max(behind->frames.first, frames.end()), behind->frames.end());
    if (left.count > 0) rest.push_back({channel, left});
    if (right.count > 0) rest.push_back({channel, right});
  }
  runs_.insert(runs_.erase(begin, behind), rest.begin(), rest.end());
}

bool SampleSelection::contains(ChannelIndex channel, FrameIndex frame) const {
  const auto run = find_run_ending_from(runs_, channel, frame + 1);
  return run != runs_.end() && run->channel == channel && run->frames.contains(frame);
}

std::span<const SampleRun> SampleSelection::runs_of(ChannelIndex channel) const {
  const auto first = std::partition_point(runs_.begin(), runs_.end(), [&](const SampleRun& r) { return r.channel < channel; });
  const auto end = std::partition_point(first, runs_.end(), [&](const SampleRun& r) { return r.channel <= channel; });
  return std::span(runs_).subspan(static_cast<std::size_t>(first - runs_.begin()), static_cast<std::size_t>(end - first));
}

std::int64_t SampleSelection::count() const {
  std::int64_t count = 0;
  for (const SampleRun& run : runs_) count += run.frames.count;
  return count;
}

std::vector<ChannelIndex> SampleSelection::channels() const {
  std::vector<ChannelIndex> channels;
  for (const SampleRun& run : runs_) {
    if (channels.empty() || channels.back() != run.channel) channels.push_back(run.channel);
  }
  return channels;
}

}  // namespace marey
