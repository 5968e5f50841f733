#include "core/signal/gaps.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace marey {
namespace {

/// The nearest usable samples around a gap, in frames from its first.
struct Neighbours {
  std::array<double, 4> frames{};
  std::array<double, 4> values{};
  int before = 0;  ///< how many of them stand before the gap; the others stand behind it
  int count = 0;

  void add(double frame, double value) {
    frames[idx(count)] = frame;
    values[idx(count)] = value;
    ++count;
  }
};

// `next` is where the next gap begins: what is in it does not count, and nor does what was not finite before.
Neighbours find_neighbours(std::span<const double> curve, const FrameRange& gap, FrameIndex next, int wanted) {
  Neighbours found;
  for (FrameIndex frame = gap.first - 1; frame >= 0 && found.count < wanted; --frame) {
    const double value = curve[idx(frame)];
    if (!std::isfinite(value)) break;
    found.add(frame - gap.first, value);
  }
  found.before = found.count;
  for (FrameIndex frame = gap.end(); frame < next && found.count < found.before + wanted; ++frame) {
    const double value = curve[idx(frame)];
    if (!std::isfinite(value)) break;
    found.add(frame - gap.first, value);
  }
  return found;
}

// Neville's scheme: the polynomial through the points, at one frame.
double polynomial_at(Neighbours points, double frame) {
  for (int span = 1; span < points.count; ++span) {
    for (int i = 0; i + span < points.count; ++i) {
      const double from = points.frames[idx(i)];
      const double to = points.frames[idx(i + span)];
      const double share = (frame - from) / (to - from);
      points.values[idx(i)] += share * (points.values[idx(i + 1)] - points.values[idx(i)]);
    }
  }
  return points.values[0];
}

// Behind the samples from `frame` on that are equal, or all not finite.
FrameIndex end_of_run(std::span<const double> curve, FrameIndex frame) {
  const double value = curve[idx(frame)];
  const auto goes_on = [value](double other) { return std::isfinite(value) ? other == value : !std::isfinite(other); };
  FrameIndex end = frame + 1;
  while (end < size_of(curve) && goes_on(curve[idx(end)])) ++end;
  return end;
}

}  // namespace

std::vector<FrameRange> find_gaps(std::span<const double> curve, int still_frames) {
  std::vector<FrameRange> gaps;
  const auto add = [&gaps](FrameIndex first, FrameIndex end) {
    if (first == end) return;
    if (gaps.empty() || gaps.back().end() != first) gaps.push_back({first, 0});
    gaps.back().count = end - gaps.back().first;
  };
  for (FrameIndex frame = 0; frame < size_of(curve);) {
    const FrameIndex end = end_of_run(curve, frame);
    if (!std::isfinite(curve[idx(frame)])) add(frame, end);
    else if (still_frames > 0 && end - frame > still_frames) add(frame + 1, end);
    frame = end;
  }
  return gaps;
}

void fill_gaps(std::span<double> curve, std::span<const FrameRange> gaps, GapFill fill) {
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const FrameIndex next = i + 1 < gaps.size() ? gaps[i + 1].first : size_of(curve);
    Neighbours points = find_neighbours(curve, gaps[i], next, fill == GapFill::Cubic ? 2 : 1);
    if (points.count == 0) continue;
    const bool has_both_sides = points.before > 0 && points.before < points.count;
    if (!has_both_sides) points.count = 1;
    for (FrameIndex frame = 0; frame < gaps[i].count; ++frame) {
      curve[idx(gaps[i].first + frame)] = polynomial_at(points, frame);
    }
  }
}

}  // namespace marey
