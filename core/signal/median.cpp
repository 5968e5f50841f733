#include "core/signal/median.h"

#include <algorithm>
#include <cmath>

namespace marey {
namespace {

constexpr int kStepsAround = 15;  // on either side of a candidate

/// Samples in rising order while a window moves over a curve.
class SortedWindow {
 public:
  void add(double value) {
    if (std::isfinite(value)) sorted_.insert(std::upper_bound(sorted_.begin(), sorted_.end(), value), value);
  }
  void remove(double value) {
    if (std::isfinite(value)) sorted_.erase(std::lower_bound(sorted_.begin(), sorted_.end(), value));
  }
  [[nodiscard]] double median() const {
    const std::size_t half = sorted_.size() / 2;
    if (sorted_.size() % 2 == 1) return sorted_[half];
    return sorted_[half - 1] + 0.5 * (sorted_[half] - sorted_[half - 1]);
  }

 private:
  std::vector<double> sorted_;
};

double median_of(std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Median size of the steps between neighbouring finite samples of a range.
double usual_step(std::span<const double> curve, FrameIndex first, FrameIndex end, std::vector<double>& steps) {
  steps.clear();
  for (FrameIndex frame = std::max(first, 0) + 1; frame < std::min(end, size_of(curve)); ++frame) {
    const double step = std::abs(curve[idx(frame)] - curve[idx(frame - 1)]);
    if (std::isfinite(step)) steps.push_back(step);
  }
  return median_of(steps);
}

std::vector<FrameRange> join_neighbours(std::span<const FrameIndex> frames) {
  std::vector<FrameRange> runs;
  for (const FrameIndex frame : frames) {
    if (runs.empty() || runs.back().end() != frame) runs.push_back({frame, 0});
    ++runs.back().count;
  }
  return runs;
}

}  // namespace

void compute_median(std::span<const double> curve, int window, std::span<double> result) {
  const int count = size_of(curve);
  const int half = (std::min(window, count) - 1) / 2;
  SortedWindow sorted;
  FrameIndex begin = 0;
  FrameIndex end = 0;
  for (FrameIndex frame = 0; frame < count; ++frame) {
    const int reach = std::min({half, frame, count - 1 - frame});
    while (end <= frame + reach) sorted.add(curve[idx(end++)]);
    while (begin < frame - reach) sorted.remove(curve[idx(begin++)]);
    result[idx(frame)] = std::isfinite(curve[idx(frame)]) ? sorted.median() : curve[idx(frame)];
  }
}

std::vector<FrameRange> find_spikes(std::span<const double> curve, const SpikeRule& rule) {
  const int count = size_of(curve);
  std::vector<double> median(curve.size());
  compute_median(curve, 2 * rule.most_frames + 1, median);
  std::vector<double> steps;
  const double height = std::max(rule.least_height, rule.times_step * usual_step(curve, 0, count, steps));
  std::vector<FrameIndex> found;
  for (FrameIndex frame = 0; frame < count; ++frame) {
    const double away = std::abs(curve[idx(frame)] - median[idx(frame)]);
    if (!(away > height)) continue;
    const double around = usual_step(curve, frame - kStepsAround, frame + kStepsAround + 1, steps);
    if (away > rule.times_step * around) found.push_back(frame);
  }
  std::vector<FrameRange> spikes = join_neighbours(found);
  std::erase_if(spikes, [&](const FrameRange& run) { return run.count > rule.most_frames; });
  return spikes;
}

}  // namespace marey
