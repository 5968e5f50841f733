#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/base/result.h"

namespace marey {

/// How a curve runs from one key to the next.
enum class Interpolation : std::uint8_t { Stepped, Linear, Bezier };

/// Where the handle of a key comes from. All but Aligned and Free follow from the keys around.
enum class HandleKind : std::uint8_t {
  Auto,         ///< the slope from the key before to the key behind; at the ends that to the only neighbour
  AutoClamped,  ///< the same, but no higher than the neighbours: flat where the curve turns and at the ends
  Aligned,      ///< as set, in line with the other handle
  Free,         ///< as set
  Flat,
  Linear,  ///< toward the neighbour
};

/// What a curve does before its first and behind its last key.
enum class Extrapolation : std::uint8_t {
  Hold,
  Linear,       ///< goes on with the slope that it has there
  Cycle,        ///< starts over
  CycleOffset,  ///< starts over from where it ended
  Oscillate,    ///< runs back and forth
};

/// The end of a handle as seen from its key.
struct Handle {
  double frames = 0.0;  ///< <= 0 to the left, >= 0 to the right
  double value = 0.0;   ///< in the unit of the curve
  friend bool operator==(const Handle&, const Handle&) = default;
};

/// A point that a curve passes through. Handles count where the span beside them is Bezier.
struct Key {
  double frame = 0.0;  ///< 0-based, not only whole
  double value = 0.0;  ///< in the unit of the curve: degrees or file units
  Interpolation interpolation = Interpolation::Bezier;  ///< up to the next key
  HandleKind left_kind = HandleKind::AutoClamped;
  HandleKind right_kind = HandleKind::AutoClamped;
  Handle left{-1.0, 0.0};  ///< of the kinds Aligned and Free
  Handle right{1.0, 0.0};
  friend bool operator==(const Key&, const Key&) = default;
};

/// A curve over time that is given by keys.
struct KeyCurve {
  std::vector<Key> keys;  ///< at least one; their frames rise
  Extrapolation before = Extrapolation::Hold;
  Extrapolation behind = Extrapolation::Hold;
  /// Whether Aligned and Free handles have lengths of their own; else only their slopes count and each reaches over a
  /// third of its span. A handle never reaches beyond the next key, so that time does not run backwards.
  bool weighted = false;
  friend bool operator==(const KeyCurve&, const KeyCurve&) = default;
};

/// Refused with InvalidArgument: no key, keys that do not rise, a handle on the wrong side; with NotFinite: what is not
/// a finite number.
[[nodiscard]] Status check_key_curve(const KeyCurve& curve);

/// Both handles of a key as they are in effect, for drawing and evaluation; without a neighbour on their side they reach
/// a third of the span on the other side, or a frame.
struct HandlePair {
  Handle left;
  Handle right;
};
[[nodiscard]] HandlePair find_handles(const KeyCurve& curve, int key);

/// Position of the last key at or before `frame`; -1 before the first.
[[nodiscard]] int find_key_before(const KeyCurve& curve, double frame);

/// The part of a curve between two keys as a cubic over time.
struct KeySpan {
  double start = 0.0;  ///< frame
  double length = 0.0;  ///< frames, > 0
  double value = 0.0;
  double end_value = 0.0;
  Handle right{};  ///< of the key where it starts
  Handle left{};   ///< of the key where it ends
  Interpolation interpolation = Interpolation::Linear;

  /// At a frame from `start` to `start + length`, both included; exact at both ends. The parameter of a weighted cubic is
  /// found to the last bits of the frame.
  [[nodiscard]] double value_at(double frame) const;
  /// Slope at the start and at the end, value per frame; 0 where a handle stands upright.
  [[nodiscard]] double start_slope() const;
  [[nodiscard]] double end_slope() const;
};

/// A curve made ready to be asked for many values. Keeps nothing of the curve that it was made of.
class KeyEvaluator {
 public:
  /// Precondition: check_key_curve(curve) is ok.
  explicit KeyEvaluator(const KeyCurve& curve);

  /// Exactly the value of a key at its frame.
  [[nodiscard]] double value_at(double frame) const;
  /// At the whole frames of a range, one value each.
  void sample(FrameRange frames, std::span<double> values) const;

 private:
  [[nodiscard]] double value_between(double frame) const;
  [[nodiscard]] double value_beyond(double frame, Extrapolation extrapolation) const;

  std::vector<KeySpan> spans_;  // of one key: a single one of length 0
  double first_frame_ = 0.0;
  double last_frame_ = 0.0;
  double single_value_ = 0.0;
  Extrapolation before_;
  Extrapolation behind_;
};

}  // namespace marey
