#include "core/editing/key_reduction.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/editing/span_fit.h"
#include "core/signal/continued_curve.h"

namespace marey {
namespace {

// Longer spans that come within rounding of the tolerance are not looked at any closer, which would take long where many
// do: straight lines without tolerance.
constexpr int kClosestFrames = 128;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Each reach tells which samples a span from one sample may end at: start() at that sample, then for each later one
// can_end_at(), and pass() to go on beyond it, unless nothing more can be reached.

class SteppedReach {
 public:
  explicit SteppedReach(const CapturedCurve& curve) : curve_(curve) {}

  void start(int from) { from_ = from; }
  [[nodiscard]] bool can_end_at(int) const { return true; }
  [[nodiscard]] bool pass(int to) const {
    return curve_.is_missing(to) || std::abs(curve_[from_] - curve_[to]) <= curve_.tolerance();
  }

 private:
  const CapturedCurve& curve_;
  int from_ = 0;
};

class LinearReach {
 public:
  explicit LinearReach(const CapturedCurve& curve) : curve_(curve), rounding_(curve.rounding()) {}

  void start(int from) {
    from_ = from;
    has_passed_ = false;
    low_ = -kInfinity;
    high_ = kInfinity;
    least_ = most_ = curve_[from];
    suspect_ = from;
  }

  [[nodiscard]] bool can_end_at(int to) {
    const Verdict verdict = judge(to);
    if (verdict != Verdict::Close || to - from_ > kClosestFrames) return verdict == Verdict::Yes;
    const KeySpan line{static_cast<double>(from_), static_cast<double>(to - from_), curve_[from_], curve_[to], {}, {},
                       Interpolation::Linear};
    return curve_.holds(line, from_, to, suspect_);
  }

  [[nodiscard]] Verdict judge(int to) const {
    if (!has_passed_) return Verdict::Yes;
    const double value = curve_[to];
    if (value == curve_[from_]) {
      const double tolerance = curve_.tolerance();
      return most_ - value <= tolerance && value - least_ <= tolerance ? Verdict::Yes : Verdict::No;
    }
    const double slope = (value - curve_[from_]) / (to - from_);
    if (slope < low_ - rounding_ || slope > high_ + rounding_) return Verdict::No;
    return slope >= low_ + rounding_ && slope <= high_ - rounding_ ? Verdict::Yes : Verdict::Close;
  }

  // Whether some slope passes all samples so far.
  [[nodiscard]] bool pass(int to) {
    if (!curve_.is_missing(to)) {
      has_passed_ = true;
      const double rise = curve_[to] - curve_[from_];
      const double frames = to - from_;
      low_ = std::max(low_, (rise - curve_.tolerance()) / frames);
      high_ = std::min(high_, (rise + curve_.tolerance()) / frames);
      least_ = std::min(least_, curve_[to]);
      most_ = std::max(most_, curve_[to]);
    }
    return low_ <= high_ + 2.0 * rounding_;
  }

 private:
  const CapturedCurve& curve_;
  double rounding_;
  int from_ = 0;
  bool has_passed_ = false;  // a sample
  double low_ = 0.0;         // the cone of slopes
  double high_ = 0.0;
  double least_ = 0.0;       // of the samples so far: a level line is exact, and so is its distance from these
  double most_ = 0.0;
  int suspect_ = 0;
};

class BezierReach {
 public:
  explicit BezierReach(const CapturedCurve& curve)
      : curve_(curve), line_(curve), fit_(curve, 0), rounding_(curve.rounding()) {}

  void start(int from) {
    from_ = from;
    line_.start(from);
    line_is_open_ = true;
    fit_ = CubicFit(curve_, from);
    suspect_ = from;
    probe_ = from + 8;
    failures_ = 0;
  }

  [[nodiscard]] bool can_end_at(int to) {
    const Verdict straight = line_is_open_ ? line_.judge(to) : Verdict::No;
    if (straight == Verdict::Yes || (failures_ < 2 && fit_holds(to))) return true;
    return straight == Verdict::Close && to - from_ <= kClosestFrames &&
           cubic_holds(curve_, from_, to, straight_slopes(curve_, from_, to), suspect_);
  }

  [[nodiscard]] bool pass(int to) {
    // Asked for every sample there, reached before or not, so that what a larger tolerance reaches includes what a
    // smaller one does.
    if (to == probe_ && failures_ < 2) {
      failures_ = fit_holds(to) ? 0 : failures_ + 1;
      probe_ += (to - from_) / 2;
    }
    if ((to - from_) % 4 == 0 && bends_too_much(to)) failures_ = 2;
    fit_.add(curve_[to]);
    line_is_open_ = line_is_open_ && line_.pass(to);
    return line_is_open_ || failures_ < 2;
  }

 private:
  // The fourth difference of a cubic is 0: no cubic from the first of five samples can be near to the others then.
  [[nodiscard]] bool bends_too_much(int to) const {
    const int step = (to - from_) / 4;
    for (int i = 1; i <= 4; ++i) {
      if (curve_.is_missing(from_ + i * step)) return false;
    }
    const double outer = curve_[from_] + curve_[to];
    const double inner = curve_[from_ + step] + curve_[to - step];
    const double difference = std::abs(outer - 4.0 * inner + 6.0 * curve_[from_ + 2 * step]);
    return difference > 15.0 * (curve_.tolerance() + rounding_);
  }

  [[nodiscard]] bool fit_holds(int to) {
    fit_.close(curve_[to]);
    const SpanSlopes slopes = fit_.slopes();
    if (to - from_ <= kClosestFrames) return cubic_holds(curve_, from_, to, slopes, suspect_);
    return judge_cubic(curve_, from_, to, slopes, suspect_) == Verdict::Yes;
  }

  const CapturedCurve& curve_;
  LinearReach line_;
  CubicFit fit_;
  double rounding_;
  bool line_is_open_ = true;
  int from_ = 0;
  int suspect_ = 0;
  int probe_ = 0;
  int failures_ = 0;
};

// Which samples are looked at as ends of spans, so that it takes no more than some 2^24 pairs at a time.
class Pairs {
 public:
  explicit Pairs(int count) : last_(count - 1), reach_(std::max(256, (1 << 24) / count)) {}

  [[nodiscard]] int end(int from) const {
    return static_cast<int>(std::min<std::int64_t>(last_, from + reach_ * spacing(from)));
  }
  [[nodiscard]] bool contains(int from, int to) const {
    return to - from <= reach_ || to - from <= reach_ * std::min(spacing(from), spacing(to));
  }

 private:
  // The largest power of two that divides a position; both ends go with every span.
  [[nodiscard]] std::int64_t spacing(int at) const { return at == 0 || at == last_ ? last_ + 1 : at & -at; }

  int last_;
  std::int64_t reach_;
};

// Zero with a sign is not what comes out of a sum: without tolerance it has to be a key, and those beside it too.
bool must_be_key(const CapturedCurve& curve, int at) {
  return curve.tolerance() == 0.0 && curve[at] == 0.0 && std::signbit(curve[at]) && !curve.is_missing(at);
}

template <class Reach>
std::vector<int> find_fewest_keys(const CapturedCurve& curve, Reach reach) {
  const int last = curve.size() - 1;
  const Pairs pairs(curve.size());
  std::vector<int> before(idx(curve.size()), -1);
  std::vector<int> reached{0};
  for (std::size_t i = 0; i < reached.size() && before[idx(last)] < 0 && last > 0; ++i) {
    const int from = reached[i];
    const int end = pairs.end(from);
    reach.start(from);
    for (int to = from + 1; to <= end; ++to) {
      if (before[idx(to)] < 0 && !curve.is_missing(to) && pairs.contains(from, to) && reach.can_end_at(to)) {
        before[idx(to)] = from;
        reached.push_back(to);
      }
      if (must_be_key(curve, to) || (must_be_key(curve, from) && !curve.is_missing(to)) || !reach.pass(to)) break;
    }
  }
  std::vector<int> keys;
  for (int at = last; at >= 0; at = before[idx(at)]) keys.push_back(at);
  std::reverse(keys.begin(), keys.end());
  return keys;
}

// The cubics between keys.
class Spline {
 public:
  Spline(const CapturedCurve& curve, const std::vector<int>& keys) : curve_(curve), keys_(keys) {
    for (int span = 0; span + 1 < size_of(keys); ++span) {
      const SpanSlopes slopes = fit(span).slopes();
      slopes_.push_back(holds(span, slopes) ? slopes : straight_slopes(curve, from(span), to(span)));
    }
  }

  [[nodiscard]] const SpanSlopes& slopes(int span) const { return slopes_[idx(span)]; }

  // Makes both slopes of the key between a span and the next equal, if it can. The next span's end slope, which is not
  // yet in line with anything, then follows its start slope.
  [[nodiscard]] bool align(int span) {
    const CubicFit left = fit(span);
    const CubicFit right = fit(span + 1);
    const double left_slope = left.end_slope(slopes(span).start);
    const double right_slope = slopes(span + 1).start;
    const double left_weight = left.end_weight();
    const double right_weight = right.start_weight();
    const double weights = left_weight + right_weight;
    double share = right_weight / weights;
    if (!(weights > 0.0)) share = static_cast<double>(length(span)) / (length(span) + length(span + 1));
    // Least squares over both spans first.
    for (const double part : {share, 0.5, 0.0, 1.0, 0.25, 0.75}) {
      const double slope = left_slope + part * (right_slope - left_slope);
      const SpanSlopes before{slopes(span).start, slope};
      const SpanSlopes behind{slope, right.end_slope(slope)};
      if (!holds(span, before) || !holds(span + 1, behind)) continue;
      slopes_[idx(span)] = before;
      slopes_[idx(span) + 1] = behind;
      return true;
    }
    return false;
  }

 private:
  [[nodiscard]] int from(int span) const { return keys_[idx(span)]; }
  [[nodiscard]] int to(int span) const { return keys_[idx(span) + 1]; }
  [[nodiscard]] int length(int span) const { return to(span) - from(span); }
  [[nodiscard]] CubicFit fit(int span) const { return {curve_, from(span), to(span)}; }
  [[nodiscard]] bool holds(int span, const SpanSlopes& slopes) const {
    int suspect = -1;
    return cubic_holds(curve_, from(span), to(span), slopes, suspect);
  }

  const CapturedCurve& curve_;
  const std::vector<int>& keys_;
  std::vector<SpanSlopes> slopes_;
};

// Slopes overflow only between neighbouring samples, where they do not matter.
void set_handles(Key& key, const Handle& left, const Handle& right, HandleKind kind) {
  const bool is_left_set = std::isfinite(left.value);
  const bool is_right_set = std::isfinite(right.value);
  if (is_left_set != is_right_set) kind = HandleKind::Free;
  key.left_kind = is_left_set ? kind : HandleKind::Linear;
  key.right_kind = is_right_set ? kind : HandleKind::Linear;
  if (is_left_set) key.left = left;
  if (is_right_set) key.right = right;
}

void set_slopes(const CapturedCurve& curve, const std::vector<int>& at, std::vector<Key>& keys) {
  Spline spline(curve, at);
  const int last = size_of(keys) - 1;
  std::vector<HandleKind> kinds(keys.size(), HandleKind::Aligned);
  for (int i = 1; i < last; ++i) {
    if (!spline.align(i - 1)) kinds[idx(i)] = HandleKind::Free;
  }
  for (int i = 0; i <= last && last > 0; ++i) {
    const int before = std::max(i - 1, 0);
    const int behind = std::min(i, last - 1);
    const double left_slope = i > 0 ? spline.slopes(before).end : spline.slopes(behind).start;
    const double right_slope = i < last ? spline.slopes(behind).start : left_slope;
    const Handle left = third_handle(left_slope, at[idx(before) + 1] - at[idx(before)], -1.0);
    const Handle right = third_handle(right_slope, at[idx(behind) + 1] - at[idx(behind)], 1.0);
    set_handles(keys[idx(i)], left, right, kinds[idx(i)]);
  }
}

std::vector<int> find_keys(const CapturedCurve& curve, Interpolation interpolation) {
  switch (interpolation) {
    case Interpolation::Stepped: return find_fewest_keys(curve, SteppedReach(curve));
    case Interpolation::Linear: return find_fewest_keys(curve, LinearReach(curve));
    default: return find_fewest_keys(curve, BezierReach(curve));
  }
}

}  // namespace

KeyCurve reduce_to_keys(std::span<const double> samples, FrameIndex first_frame, const KeyReduction& reduction) {
  KeyCurve result;
  const FrameRange finite = find_finite_frames(samples);
  if (finite.count == 0) {
    Key key;
    key.frame = first_frame;
    key.interpolation = reduction.interpolation;
    result.keys.push_back(key);
    return result;
  }
  const double tolerance = reduction.tolerance > 0.0 ? reduction.tolerance : 0.0;
  const CapturedCurve curve(samples.subspan(idx(finite.first), idx(finite.count)), tolerance);
  const std::vector<int> at = find_keys(curve, reduction.interpolation);
  for (const int sample : at) {
    Key key;
    key.frame = static_cast<double>(first_frame) + finite.first + sample;
    key.value = curve[sample];
    key.interpolation = reduction.interpolation;
    if (reduction.interpolation == Interpolation::Linear) key.left_kind = key.right_kind = HandleKind::Linear;
    result.keys.push_back(key);
  }
  if (reduction.interpolation == Interpolation::Bezier) set_slopes(curve, at, result.keys);
  return result;
}

}  // namespace marey
