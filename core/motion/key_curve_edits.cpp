#include "core/motion/key_curve_edits.h"

#include <algorithm>
#include <cmath>

namespace marey {
namespace {

bool is_set(HandleKind kind) { return kind == HandleKind::Aligned || kind == HandleKind::Free; }

// A handle that is in effect, as one that is set: it stays where it is.
void fix_handle(Handle& handle, HandleKind& kind, const Handle& in_effect) {
  if (is_set(kind)) return;
  handle = in_effect;
  kind = HandleKind::Free;
}

Handle scaled(const Handle& handle, double factor) { return {handle.frames * factor, handle.value * factor}; }

double slope_of(const Handle& handle) { return handle.frames != 0.0 ? handle.value / handle.frames : 0.0; }

struct Point {
  double frame = 0.0;
  double value = 0.0;
};

Point between(const Point& a, const Point& b, double u) { return {std::lerp(a.frame, b.frame, u), std::lerp(a.value, b.value, u)}; }

// The parameter of a Bezier at a frame, by bisection: as it is for one key at a time, plainness goes first.
double parameter_at(const Point (&p)[4], double frame) {
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double u = 0.5 * (low + high);
    const double v = 1.0 - u;
    const double at = v * v * v * p[0].frame + 3.0 * u * v * v * p[1].frame + 3.0 * u * u * v * p[2].frame + u * u * u * p[3].frame;
    (at < frame ? low : high) = u;
  }
  return 0.5 * (low + high);
}

// Splits the Bezier between two keys at a third one, which is between them (de Casteljau).
void split_span(KeyCurve& curve, int before, Key& middle) {
  Key& from = curve.keys[idx(before)];
  Key& to = curve.keys[idx(before) + 1];
  const Handle right = find_handles(curve, before).right;
  const Handle left = find_handles(curve, before + 1).left;
  const Point p[4] = {{from.frame, from.value},
                      {from.frame + right.frames, from.value + right.value},
                      {to.frame + left.frames, to.value + left.value},
                      {to.frame, to.value}};
  const double u = parameter_at(p, middle.frame);
  const Point b = between(p[1], p[2], u);
  const Point ab = between(between(p[0], p[1], u), b, u);
  const Point bc = between(b, between(p[2], p[3], u), u);
  middle.left = {std::min(ab.frame - middle.frame, 0.0), ab.value - middle.value};
  middle.right = {std::max(bc.frame - middle.frame, 0.0), bc.value - middle.value};
  middle.left_kind = middle.right_kind = HandleKind::Aligned;
  fix_handle(from.right, from.right_kind, right);
  fix_handle(to.left, to.left_kind, left);
  if (!curve.weighted) return;
  from.right = scaled(right, u);
  to.left = scaled(left, 1.0 - u);
}

template <class Change>
void for_keys_within(KeyCurve& curve, double first, double last, Change change) {
  for (int i = 0; i < size_of(curve.keys); ++i) {
    const Key& key = curve.keys[idx(i)];
    if (key.frame >= first - kSameKeyFrames && key.frame <= last + kSameKeyFrames) change(i);
  }
}

int insert_sorted(KeyCurve& curve, const Key& key) {
  const int at = find_key_before(curve, key.frame) + 1;
  curve.keys.insert(curve.keys.begin() + at, key);
  return at;
}

}  // namespace

int find_key_at(const KeyCurve& curve, double frame) {
  const int key = find_key_before(curve, frame + kSameKeyFrames);
  return key >= 0 && std::abs(curve.keys[idx(key)].frame - frame) <= kSameKeyFrames ? key : -1;
}

int set_key(KeyCurve& curve, double frame, double value) {
  const int present = find_key_at(curve, frame);
  if (present >= 0) {
    curve.keys[idx(present)].value = value;
    return present;
  }
  Key key;
  key.frame = frame;
  key.value = value;
  const int before = find_key_before(curve, frame);
  if (before >= 0) key.interpolation = curve.keys[idx(before)].interpolation;
  return insert_sorted(curve, key);
}

int insert_key(KeyCurve& curve, double frame) {
  const int present = find_key_at(curve, frame);
  if (present >= 0) return present;
  Key key;
  key.frame = frame;
  key.value = KeyEvaluator(curve).value_at(frame);
  const int before = find_key_before(curve, frame);
  if (before >= 0) key.interpolation = curve.keys[idx(before)].interpolation;
  const bool is_between = before >= 0 && before + 1 < size_of(curve.keys);
  if (is_between && key.interpolation == Interpolation::Bezier) split_span(curve, before, key);
  return insert_sorted(curve, key);
}

void delete_keys(KeyCurve& curve, double first, double last) {
  std::erase_if(curve.keys, [&](const Key& key) {
    return key.frame >= first - kSameKeyFrames && key.frame <= last + kSameKeyFrames;
  });
}

void move_keys(KeyCurve& curve, std::span<const int> keys, double frames, double value) {
  std::vector<Key> moved;
  moved.reserve(keys.size());
  for (const int key : keys) moved.push_back(curve.keys[idx(key)]);
  for (auto key = keys.rbegin(); key != keys.rend(); ++key) curve.keys.erase(curve.keys.begin() + *key);
  for (Key& key : moved) {
    key.frame += frames;
    key.value += value;
    delete_keys(curve, key.frame, key.frame);
  }
  for (const Key& key : moved) insert_sorted(curve, key);
}

void set_interpolation(KeyCurve& curve, double first, double last, Interpolation interpolation) {
  for_keys_within(curve, first, last, [&](int key) { curve.keys[idx(key)].interpolation = interpolation; });
}

void set_handle_kinds(KeyCurve& curve, double first, double last, HandleKind kind) {
  const KeyCurve before = curve;
  for_keys_within(curve, first, last, [&](int i) {
    Key& key = curve.keys[idx(i)];
    if (is_set(kind)) {
      const HandlePair pair = find_handles(before, i);
      key.left = pair.left;
      key.right = pair.right;
    }
    if (kind == HandleKind::Aligned) {
      const double slope = 0.5 * (slope_of(key.left) + slope_of(key.right));
      key.left.value = slope * key.left.frames;
      key.right.value = slope * key.right.frames;
    }
    key.left_kind = key.right_kind = kind;
  });
}

void pull_handle(KeyCurve& curve, int key, HandleSide side, Handle handle) {
  const HandlePair pair = find_handles(curve, key);
  Key& k = curve.keys[idx(key)];
  const bool is_left = side == HandleSide::Left;
  handle.frames = is_left ? std::min(handle.frames, 0.0) : std::max(handle.frames, 0.0);
  HandleKind& kind = is_left ? k.left_kind : k.right_kind;
  HandleKind& other_kind = is_left ? k.right_kind : k.left_kind;
  Handle& other = is_left ? k.right : k.left;
  if (kind != HandleKind::Free) {
    if (!is_set(other_kind)) other = is_left ? pair.right : pair.left;
    kind = other_kind = HandleKind::Aligned;
    if (handle.frames != 0.0) other.value = slope_of(handle) * other.frames;
  }
  (is_left ? k.left : k.right) = handle;
}

}  // namespace marey
