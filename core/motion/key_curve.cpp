#include "core/motion/key_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace marey {
namespace {

bool is_finite(const Handle& handle) { return std::isfinite(handle.frames) && std::isfinite(handle.value); }

bool is_finite(const Key& key) {
  return std::isfinite(key.frame) && std::isfinite(key.value) && is_finite(key.left) && is_finite(key.right);
}

// The slopes of the straight lines to the neighbours of a key.
struct Neighbours {
  double before = 0.0;
  double behind = 0.0;
  double across = 0.0;  // from neighbour to neighbour
  bool has_before = false;
  bool has_behind = false;
};

double slope_between(const Key& a, const Key& b) { return (b.value - a.value) / (b.frame - a.frame); }

Neighbours find_neighbours(const KeyCurve& curve, int key) {
  const auto& keys = curve.keys;
  Neighbours n;
  n.has_before = key > 0;
  n.has_behind = key + 1 < size_of(keys);
  if (n.has_before) n.before = slope_between(keys[idx(key) - 1], keys[idx(key)]);
  if (n.has_behind) n.behind = slope_between(keys[idx(key)], keys[idx(key) + 1]);
  if (n.has_before && n.has_behind) {
    n.across = slope_between(keys[idx(key) - 1], keys[idx(key) + 1]);
  } else {
    n.across = n.has_before ? n.before : n.behind;
  }
  return n;
}

// Three times the slope of a straight line is the steepest with which a cubic stays between its ends (Fritsch and
// Carlson, Monotone piecewise cubic interpolation, 1980).
double clamped_slope(const Neighbours& n) {
  const bool turns = !n.has_before || !n.has_behind || n.before * n.behind <= 0.0;
  if (turns) return 0.0;
  const double most = 3.0 * std::min(std::abs(n.before), std::abs(n.behind));
  return std::clamp(n.across, -most, most);
}

double slope_of(const Handle& handle) { return handle.frames != 0.0 ? handle.value / handle.frames : 0.0; }

double derived_slope(HandleKind kind, const Neighbours& n, double toward) {
  switch (kind) {
    case HandleKind::Auto: return n.across;
    case HandleKind::AutoClamped: return clamped_slope(n);
    case HandleKind::Linear: return toward;
    default: return 0.0;
  }
}

bool is_set(HandleKind kind) { return kind == HandleKind::Aligned || kind == HandleKind::Free; }

// `side` is -1 to the left and 1 to the right, `span` the frames up to the neighbour there.
Handle effective(HandleKind kind, const Handle& set, double slope, double side, double span, bool weighted) {
  if (!is_set(kind) || !weighted) {
    const double reach = side * span / 3.0;
    return {reach, (is_set(kind) ? slope_of(set) : slope) * reach};
  }
  const double length = std::abs(set.frames);
  if (length <= span) return set;
  return {side * span, set.value * (span / length)};
}

double hermite(double u, double value, double rise, double right, double left) {
  // Bezier ordinates relative to `value`: 0, right, rise + left, rise.
  const double v = 1.0 - u;
  return value + u * (3.0 * v * v * right + u * (3.0 * v * (rise + left) + u * rise));
}

// The parameter at which the abscissa of the Bezier 0, a, b, 1 is x: Newton's method within a bracket that shrinks, as
// a handle may stand upright. The abscissa rises, because a and b lie within 0 ... 1.
double find_parameter(double x, double a, double b) {
  double low = 0.0;
  double high = 1.0;
  double u = x;
  for (int i = 0; i < 80; ++i) {
    const double v = 1.0 - u;
    const double error = u * (3.0 * v * v * a + u * (3.0 * v * b + u)) - x;
    if (error == 0.0) return u;
    (error > 0.0 ? high : low) = u;
    const double slope = 3.0 * (v * v * a + 2.0 * u * v * (b - a) + u * u * (1.0 - b));
    double next = u - error / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == u || next <= low || next >= high) return u;
    u = next;
  }
  return u;
}

KeySpan make_span(const KeyCurve& curve, int key) {
  const Key& from = curve.keys[idx(key)];
  const Key& to = curve.keys[idx(key) + 1];
  KeySpan span{from.frame, to.frame - from.frame, from.value, to.value, {}, {}, from.interpolation};
  if (from.interpolation == Interpolation::Bezier) {
    span.right = find_handles(curve, key).right;
    span.left = find_handles(curve, key + 1).left;
  }
  return span;
}

}  // namespace

Status check_key_curve(const KeyCurve& curve) {
  const auto refusal = [](DiagnosticCode code, std::string message) { return Error{code, {}, std::move(message), {}, {}}; };
  if (curve.keys.empty()) return refusal(DiagnosticCode::InvalidArgument, "A curve of keys has one key at least.");
  for (std::size_t i = 0; i < curve.keys.size(); ++i) {
    const Key& key = curve.keys[i];
    if (!is_finite(key)) {
      return refusal(DiagnosticCode::NotFinite, fmt::format("Key {} is not made of finite numbers.", i + 1));
    }
    if (key.left.frames > 0.0 || key.right.frames < 0.0) {
      return refusal(DiagnosticCode::InvalidArgument, fmt::format("A handle of key {} points to the wrong side.", i + 1));
    }
    if (i > 0 && !(key.frame > curve.keys[i - 1].frame)) {
      return refusal(DiagnosticCode::InvalidArgument,
                     fmt::format("Key {} lies at frame {}, not behind the key before it.", i + 1, key.frame + 1.0));
    }
  }
  return {};
}

HandlePair find_handles(const KeyCurve& curve, int key) {
  const auto& keys = curve.keys;
  const Key& k = keys[idx(key)];
  const Neighbours n = find_neighbours(curve, key);
  const double behind = n.has_behind ? keys[idx(key) + 1].frame - k.frame : 0.0;
  const double before = n.has_before ? k.frame - keys[idx(key) - 1].frame : behind > 0.0 ? behind : 3.0;
  HandlePair pair;
  pair.left = effective(k.left_kind, k.left, derived_slope(k.left_kind, n, n.has_before ? n.before : n.behind), -1.0, before,
                        curve.weighted);
  pair.right = effective(k.right_kind, k.right, derived_slope(k.right_kind, n, n.has_behind ? n.behind : n.before), 1.0,
                         n.has_behind ? behind : before, curve.weighted);
  return pair;
}

int find_key_before(const KeyCurve& curve, double frame) {
  const auto later = std::upper_bound(curve.keys.begin(), curve.keys.end(), frame,
                                      [](double at, const Key& key) { return at < key.frame; });
  return static_cast<int>(later - curve.keys.begin()) - 1;
}

double KeySpan::value_at(double frame) const {
  if (frame >= start + length) return end_value;
  if (frame <= start || interpolation == Interpolation::Stepped) return value;
  const double x = (frame - start) / length;
  const double rise = end_value - value;
  if (interpolation == Interpolation::Linear) return value + x * rise;
  constexpr double kThird = 1.0 / 3.0;
  const double a = right.frames / length;
  const double b = 1.0 + left.frames / length;
  const bool is_even = std::abs(a - kThird) < 1e-15 && std::abs(b - 2.0 * kThird) < 1e-15;
  return hermite(is_even ? x : find_parameter(x, a, b), value, rise, right.value, left.value);
}

double KeySpan::start_slope() const {
  if (interpolation == Interpolation::Stepped) return 0.0;
  return interpolation == Interpolation::Linear ? (end_value - value) / length : slope_of(right);
}

double KeySpan::end_slope() const {
  if (interpolation == Interpolation::Stepped) return 0.0;
  return interpolation == Interpolation::Linear ? (end_value - value) / length : slope_of(left);
}

KeyEvaluator::KeyEvaluator(const KeyCurve& curve)
    : first_frame_(curve.keys.front().frame),
      last_frame_(curve.keys.back().frame),
      single_value_(curve.keys.front().value),
      before_(curve.before),
      behind_(curve.behind) {
  spans_.reserve(curve.keys.size() - 1);
  for (int key = 0; key + 1 < size_of(curve.keys); ++key) spans_.push_back(make_span(curve, key));
}

double KeyEvaluator::value_at(double frame) const {
  if (spans_.empty()) return single_value_;
  if (frame < first_frame_) return value_beyond(frame, before_);
  if (frame > last_frame_) return value_beyond(frame, behind_);
  return value_between(frame);
}

void KeyEvaluator::sample(FrameRange frames, std::span<double> values) const {
  auto span = spans_.begin();
  for (int i = 0; i < frames.count; ++i) {
    const double frame = frames.first + i;
    if (spans_.empty() || frame < first_frame_ || frame > last_frame_) {
      values[idx(i)] = value_at(frame);
      continue;
    }
    while (span + 1 != spans_.end() && (span + 1)->start <= frame) ++span;
    values[idx(i)] = span->value_at(frame);
  }
}

double KeyEvaluator::value_between(double frame) const {
  const auto later = std::upper_bound(spans_.begin() + 1, spans_.end(), frame,
                                      [](double at, const KeySpan& span) { return at < span.start; });
  return (later - 1)->value_at(frame);
}

double KeyEvaluator::value_beyond(double frame, Extrapolation extrapolation) const {
  const bool is_before = frame < first_frame_;
  const KeySpan& near = is_before ? spans_.front() : spans_.back();
  const double end = is_before ? near.value : near.end_value;
  if (extrapolation == Extrapolation::Hold) return end;
  if (extrapolation == Extrapolation::Linear) {
    return is_before ? end + near.start_slope() * (frame - first_frame_) : end + near.end_slope() * (frame - last_frame_);
  }
  const double period = last_frame_ - first_frame_;
  const double rounds = std::floor((frame - first_frame_) / period);
  const double within = std::clamp(frame - rounds * period, first_frame_, last_frame_);
  if (extrapolation == Extrapolation::Oscillate && std::fmod(rounds, 2.0) != 0.0) {
    return value_between(first_frame_ + last_frame_ - within);
  }
  const double gain = spans_.back().end_value - spans_.front().value;
  return value_between(within) + (extrapolation == Extrapolation::CycleOffset ? rounds * gain : 0.0);
}

}  // namespace marey
