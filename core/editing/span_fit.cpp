#include "core/editing/span_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/index.h"
#include "core/signal/continued_curve.h"

namespace marey {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// With n frames, over k = 1 ... n - 1 (by Faulhaber's formula and the symmetry of k and n - k):
// sum k^2 (n - k)^2 = n (n^4 - 1) / 30, sum k^3 (n - k) = n^3 (n^2 - 1) / 12 - the former,
// sum k^3 (n - k)^3 = n^7 / 140 + n^3 / 60 - n / 42, sum k^2 (n - k)^4 = n^2 / 2 times the first - the former.
CubicSums compute_cubic_sums(int length) {
  const double n = length;
  const double n2 = n * n;
  const double n4 = n2 * n2;
  const double squares = n * (n4 - 1.0) / 30.0;
  const double cubes = n * (n4 * n2 / 140.0 + n2 / 60.0 - 1.0 / 42.0);
  CubicSums sums;
  sums.inverse = 1.0 / n;
  sums.aa = (0.5 * n2 * squares - cubes) / (n4 * n2);
  sums.ab = cubes / (n4 * n2);
  sums.ax = squares / n4;
  sums.bx = (n * n2 * (n2 - 1.0) / 12.0 - squares) / n4;
  if (length > 1) sums.inverse_sum = 1.0 / (sums.aa + sums.ab);
  if (length > 2) sums.inverse_difference = 1.0 / (sums.aa - sums.ab);
  return sums;
}

CubicSums find_cubic_sums(int length) {
  static const std::vector<CubicSums> table = [] {
    std::vector<CubicSums> sums(1024);
    for (int i = 1; i < size_of(sums); ++i) sums[idx(i)] = compute_cubic_sums(i);
    return sums;
  }();
  return length < size_of(table) ? table[idx(length)] : compute_cubic_sums(length);
}

}  // namespace

CapturedCurve::CapturedCurve(std::span<const double> samples, double tolerance)
    : values_(bridged(samples, {0, size_of(samples)})), missing_(samples.size()), tolerance_(tolerance) {
  for (int i = 0; i < size(); ++i) {
    missing_[idx(i)] = std::isfinite(samples[idx(i)]) ? 0 : 1;
    if (!is_missing(i)) largest_ = std::max(largest_, std::abs(values_[idx(i)]));
  }
}

double CapturedCurve::rounding(double also) const {
  const double size = largest_ + tolerance_ + also;
  return size < 1e300 ? 64.0 * kEpsilon * size + std::numeric_limits<double>::min() : kInfinity;
}

bool CapturedCurve::holds(const KeySpan& span, int from, int to, int& suspect) const {
  const auto find_far = [&](int first, int end) {
    while (first < end && (is_missing(first) || std::abs(span.value_at(first) - values_[idx(first)]) <= tolerance_)) ++first;
    return first;
  };
  const int middle = suspect > from && suspect < to ? suspect : from + 1;
  int far = find_far(middle, to);
  if (far == to) {
    far = find_far(from + 1, middle);
    if (far == middle) return true;
  }
  suspect = far;
  return false;
}

Handle third_handle(double slope, double length, double side) {
  const double reach = side * length / 3.0;
  return {reach, slope * reach};
}

KeySpan make_cubic(const CapturedCurve& curve, int from, int to, const SpanSlopes& slopes) {
  const double length = to - from;
  // The evaluator takes the slopes from the handles that it is given.
  const auto effective = [length](double slope, double side) {
    const Handle set = third_handle(slope, length, side);
    return Handle{set.frames, set.value / set.frames * set.frames};
  };
  return {static_cast<double>(from),    length, curve[from], curve[to], effective(slopes.start, 1.0),
          effective(slopes.end, -1.0), Interpolation::Bezier};
}

Verdict judge_cubic(const CapturedCurve& curve, int from, int to, const SpanSlopes& slopes, int& suspect) {
  const double length = to - from;
  const double inverse = 1.0 / length;
  const double start = curve[from];
  const double line = (curve[to] - start) * inverse;
  const double c2 = (3.0 * line - 2.0 * slopes.start - slopes.end) * inverse;
  const double c3 = (slopes.start + slopes.end - 2.0 * line) * (inverse * inverse);
  const double rounding = curve.rounding(4.0 * length * (std::abs(slopes.start) + std::abs(slopes.end) + std::abs(line)));
  const double near = curve.tolerance() - rounding;
  const double far = curve.tolerance() + rounding;
  Verdict verdict = Verdict::Yes;
  const auto judge = [&](int first, int end) {
    for (int at = first; at < end; ++at) {
      const double k = at - from;
      const double error = std::abs(k * (slopes.start + k * (c2 + k * c3)) - (curve[at] - start));
      if (error <= near || curve.is_missing(at)) continue;
      verdict = Verdict::Close;
      if (!(error > far)) continue;
      suspect = at;
      verdict = Verdict::No;
      return;
    }
  };
  const int middle = suspect > from && suspect < to ? suspect : from + 1;
  judge(middle, to);
  if (verdict != Verdict::No) judge(from + 1, middle);
  return verdict;
}

bool cubic_holds(const CapturedCurve& curve, int from, int to, const SpanSlopes& slopes, int& suspect) {
  const Verdict verdict = judge_cubic(curve, from, to, slopes, suspect);
  if (verdict != Verdict::Close) return verdict == Verdict::Yes;
  return curve.holds(make_cubic(curve, from, to, slopes), from, to, suspect);
}

SpanSlopes straight_slopes(const CapturedCurve& curve, int from, int to) {
  const double slope = (curve[to] - curve[from]) / (to - from);
  return {slope, slope};
}

CubicFit::CubicFit(const CapturedCurve& curve, int from, int to) : CubicFit(curve, from) {
  for (int at = from + 1; at < to; ++at) add(curve[at]);
  close(curve[to]);
}

void CubicFit::close(double value) {
  sums_ = find_cubic_sums(inner_ + 1);
  rise_ = value - start_;
  const double inverse = sums_.inverse;
  ar_ = inverse * (first_ + inverse * (inverse * third_ - 2.0 * second_)) - rise_ * sums_.ax;
  br_ = inverse * inverse * (second_ - inverse * third_) - rise_ * sums_.bx;
}

// A single frame between says nothing about the difference of a and b.
SpanSlopes CubicFit::slopes() const {
  const double half_sum = 0.5 * (ar_ + br_) * sums_.inverse_sum;
  const double half_difference = 0.5 * (ar_ - br_) * sums_.inverse_difference;
  return {(rise_ + (half_sum + half_difference)) * sums_.inverse, (rise_ - (half_sum - half_difference)) * sums_.inverse};
}

double CubicFit::end_slope(double start_slope) const {
  if (inner_ == 0) return rise_;
  const double a = start_slope / sums_.inverse - rise_;
  return (rise_ - (br_ - sums_.ab * a) / sums_.aa) * sums_.inverse;
}

double CubicFit::end_weight() const { return inner_ > 0 ? sums_.aa / (sums_.inverse * sums_.inverse) : 0.0; }

double CubicFit::start_weight() const {
  if (inner_ < 2) return 0.0;
  return (sums_.aa - sums_.ab * sums_.ab / sums_.aa) / (sums_.inverse * sums_.inverse);
}

}  // namespace marey
