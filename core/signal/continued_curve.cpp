#include "core/signal/continued_curve.h"

#include <cmath>

namespace marey {

ContinuedCurve::ContinuedCurve(std::span<const double> curve) : curve_(curve), last_(std::ssize(curve) - 1) {
  while (first_ < last_ && !std::isfinite(at(first_))) ++first_;
  while (last_ > first_ && !std::isfinite(at(last_))) --last_;
}

double ContinuedCurve::operator[](std::int64_t frame) const {
  if (frame >= first_ && frame <= last_) return at(frame);
  const std::int64_t span = last_ - first_;
  if (span <= 0) return at(first_);
  const std::int64_t period = 2 * span;
  const std::int64_t from_first = frame - first_;
  const std::int64_t phase = ((from_first % period) + period) % period;
  const double rise = 2.0 * (at(last_) - at(first_)) * static_cast<double>((from_first - phase) / period);
  if (phase <= span) return at(first_ + phase) + rise;
  return 2.0 * at(last_) - at(first_ + period - phase) + rise;
}

FrameRange find_finite_frames(std::span<const double> curve) {
  FrameIndex first = 0;
  FrameIndex end = size_of(curve);
  while (first < end && !std::isfinite(curve[idx(first)])) ++first;
  while (end > first && !std::isfinite(curve[idx(end - 1)])) --end;
  return {first, end - first};
}

std::vector<double> bridged(std::span<const double> curve, FrameRange range) {
  const std::span<const double> part = curve.subspan(idx(range.first), idx(range.count));
  std::vector<double> result(part.begin(), part.end());
  for (std::size_t i = 1; i < result.size(); ++i) {
    if (std::isfinite(result[i])) continue;
    std::size_t behind = i + 1;
    while (behind + 1 < result.size() && !std::isfinite(result[behind])) ++behind;
    const double from = result[i - 1];
    const double step = (result[behind] - from) / static_cast<double>(behind - i + 1);
    for (std::size_t k = i; k < behind; ++k) result[k] = from + step * static_cast<double>(k - i + 1);
    i = behind;
  }
  return result;
}

void keep_missing(std::span<const double> curve, std::span<double> result) {
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!std::isfinite(curve[i])) result[i] = curve[i];
  }
}

}  // namespace marey
