#include "core/signal/savitzky_golay.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/signal/continued_curve.h"

namespace marey {
namespace {

/// Values of a polynomial and of its first two derivatives.
struct Jet {
  double value = 0.0;
  double first = 0.0;
  double second = 0.0;

  [[nodiscard]] double derivative(int order) const { return order == 0 ? value : order == 1 ? first : second; }
};

// The next one of the orthogonal polynomials over a symmetric window: p[k+1] = x p[k] - b p[k-1].
Jet next_polynomial(double x, double b, const Jet& p, const Jet& before) {
  return {x * p.value - b * before.value, p.value + x * p.first - b * before.first,
          2.0 * p.first + x * p.second - b * before.second};
}

// As what the curve's first and last samples allow.
SavitzkyGolay fitted_to(const SavitzkyGolay& filter, int count) {
  SavitzkyGolay fitted = filter;
  if (fitted.window > count) fitted.window = count % 2 == 0 ? count - 1 : count;
  fitted.degree = std::clamp(fitted.degree, 0, fitted.window - 1);
  return fitted;
}

// Relative to one of the samples, so that constants come out to the bit.
double weighted(std::span<const double> weights, const double* samples, double reference, int derivative) {
  double sum = derivative == 0 ? reference : 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * (samples[i] - reference);
  return sum;
}

}  // namespace

std::vector<double> make_savitzky_golay_weights(const SavitzkyGolay& filter, int at) {
  const int half = (filter.window - 1) / 2;
  const double scale = half > 0 ? half : 1.0;  // x runs from -1 to 1, which keeps the polynomials small
  std::vector<Jet> p(idx(filter.window), Jet{1.0, 0.0, 0.0});
  std::vector<Jet> before(p.size());
  std::vector<double> weights(p.size(), 0.0);
  double norm_before = 1.0;
  for (int k = 0; k <= filter.degree; ++k) {
    double norm = 0.0;
    for (const Jet& jet : p) norm += jet.value * jet.value;
    const double factor = p[idx(half + at)].derivative(filter.derivative) / (norm * std::pow(scale, filter.derivative));
    for (std::size_t i = 0; i < p.size(); ++i) weights[i] += factor * p[i].value;
    const double b = k > 0 ? norm / norm_before : 0.0;
    norm_before = norm;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double x = (static_cast<double>(i) - half) / scale;
      before[i] = std::exchange(p[i], next_polynomial(x, b, p[i], before[i]));
    }
  }
  return weights;
}

void compute_savitzky_golay(std::span<const double> curve, const SavitzkyGolay& filter, std::span<double> result) {
  std::fill(result.begin(), result.end(), 0.0);
  const FrameRange frames = find_finite_frames(curve);
  if (frames.count > 0) {
    const std::vector<double> samples = bridged(curve, frames);
    const SavitzkyGolay fitted = fitted_to(filter, frames.count);
    const int half = (fitted.window - 1) / 2;
    const std::span<double> out = result.subspan(idx(frames.first), idx(frames.count));
    const std::vector<double> middle = make_savitzky_golay_weights(fitted, 0);
    for (int i = half; i < frames.count - half; ++i) {
      out[idx(i)] = weighted(middle, samples.data() + (i - half), samples[idx(i)], fitted.derivative);
    }
    const double* last_window = samples.data() + (frames.count - fitted.window);
    for (int i = 0; i < half; ++i) {
      out[idx(i)] = weighted(make_savitzky_golay_weights(fitted, i - half), samples.data(), samples[idx(i)], fitted.derivative);
    }
    // An even number of samples has one more than the window, so the two edges never overlap the middle.
    for (int i = std::max(half, frames.count - half); i < frames.count; ++i) {
      const int at = i - (frames.count - 1 - half);
      out[idx(i)] = weighted(make_savitzky_golay_weights(fitted, at), last_window, samples[idx(i)], fitted.derivative);
    }
  }
  keep_missing(curve, result);
}

}  // namespace marey
