#pragma once

#include <span>
#include <vector>

#include "core/motion/key_curve.h"

namespace marey {

/// Whether a span stays within the tolerance. Close: rounding in the evaluation decides.
enum class Verdict { No, Close, Yes };

/// What reduce_to_keys() looks at: samples from the first to the last finite one, at least one, and how near to stay.
class CapturedCurve {
 public:
  /// Precondition: the first and the last of `samples` are finite.
  CapturedCurve(std::span<const double> samples, double tolerance);

  [[nodiscard]] int size() const { return static_cast<int>(values_.size()); }
  /// Where there is no finite sample, on the straight line between those around.
  [[nodiscard]] double operator[](int at) const { return values_[static_cast<std::size_t>(at)]; }
  [[nodiscard]] bool is_missing(int at) const { return missing_[static_cast<std::size_t>(at)] != 0; }
  [[nodiscard]] double tolerance() const { return tolerance_; }
  /// More than rounding takes from a span whose terms are as large as the samples and `also`; infinite where those may
  /// overflow.
  [[nodiscard]] double rounding(double also = 0.0) const;
  /// Whether the evaluated span stays within the tolerance of all samples between `from` and `to`. Those from `suspect`
  /// on are looked at first; it becomes the one that is too far away, where the next span is likely to fail as well.
  [[nodiscard]] bool holds(const KeySpan& span, int from, int to, int& suspect) const;

 private:
  std::vector<double> values_;
  std::vector<char> missing_;
  double tolerance_ = 0.0;
  double largest_ = 0.0;
};

/// Slopes at the ends of a cubic, value per frame.
struct SpanSlopes {
  double start = 0.0;
  double end = 0.0;
};

/// A handle of a third of a span of `length` frames; `side` is -1 to the left, 1 to the right.
[[nodiscard]] Handle third_handle(double slope, double length, double side);
/// The span between two samples as KeyEvaluator makes it of keys with such handles.
[[nodiscard]] KeySpan make_cubic(const CapturedCurve& curve, int from, int to, const SpanSlopes& slopes);
/// Far faster than the evaluator. For `suspect` see CapturedCurve::holds().
[[nodiscard]] Verdict judge_cubic(const CapturedCurve& curve, int from, int to, const SpanSlopes& slopes, int& suspect);
[[nodiscard]] bool cubic_holds(const CapturedCurve& curve, int from, int to, const SpanSlopes& slopes, int& suspect);
[[nodiscard]] SpanSlopes straight_slopes(const CapturedCurve& curve, int from, int to);

/// Sums over the frames between both ends of a span of some length: of A A = B B, A B, A x and B x (see CubicFit).
struct CubicSums {
  double inverse = 1.0;  // of the length
  double aa = 0.0;
  double ab = 0.0;
  double ax = 0.0;
  double bx = 0.0;
  double inverse_sum = 0.0;         // of aa + ab; 0 without frames between
  double inverse_difference = 0.0;  // of aa - ab; 0 with less than two
};

/// The least-squares cubic from one sample to another, through both: line + a A + b B over x in 0 ... 1 with
/// A = x (1 - x)^2 and B = x^2 (1 - x). The samples between are added one by one.
class CubicFit {
 public:
  CubicFit(const CapturedCurve& curve, int from) : start_(curve[from]) {}
  CubicFit(const CapturedCurve& curve, int from, int to);

  /// The next sample lies between both ends.
  void add(double value) {
    inner_ += 1;
    const double k = inner_;
    const double moment = k * (value - start_);
    first_ += moment;
    second_ += k * moment;
    third_ += k * (k * moment);
  }
  /// `value` is the end, one frame behind those added. More can be added afterwards, which opens the span again.
  void close(double value);

  /// Of what close() closed.
  [[nodiscard]] SpanSlopes slopes() const;
  /// The best end slope when the start slope is given.
  [[nodiscard]] double end_slope(double start_slope) const;
  /// By how much the sum of squares grows with the square of an error in the end slope when the start slope is given, and
  /// in the start slope when the end slope follows it.
  [[nodiscard]] double end_weight() const;
  [[nodiscard]] double start_weight() const;

 private:
  double start_;
  int inner_ = 0;       // frames between, so far
  double first_ = 0.0;  // sums of k^m (value - start) over the frames k, m = 1, 2, 3
  double second_ = 0.0;
  double third_ = 0.0;
  CubicSums sums_;
  double rise_ = 0.0;
  double ar_ = 0.0;  // sums of A r, B r; r is what the line leaves
  double br_ = 0.0;
};

}  // namespace marey
