#include "core/signal/butterworth.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "core/signal/continued_curve.h"

namespace marey {
namespace {

// The filter's memory fades by e^(-sqrt(2) pi) per period of the cut-off: by 1e-10 in as many.
constexpr double kPeriodsToForget = 5.2;
// Continued by more than some lengths of itself the curve only repeats.
constexpr double kMostLengths = 8.0;

void run_forwards(const ButterworthCoefficients& f, std::span<double> samples) {
  if (samples.empty()) return;
  // Steady state of the first sample: as if it had been there always.
  double x1 = samples[0];
  double x2 = samples[0];
  double y1 = samples[0];
  double y2 = samples[0];
  for (double& sample : samples) {
    const double x = sample;
    const double y = f.a0 * x + f.a1 * x1 + f.a2 * x2 + f.b1 * y1 + f.b2 * y2;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = y;
    sample = y;
  }
}

// `samples` begins and ends with 0, so that its continuation is an odd periodic curve.
void filter_both_ways(const ButterworthCoefficients& filter, std::size_t reach, std::span<double> samples) {
  const ContinuedCurve continued(samples);
  std::vector<double> padded(samples.size() + 2 * reach);
  for (std::size_t i = 0; i < padded.size(); ++i) {
    padded[i] = continued[static_cast<std::int64_t>(i) - static_cast<std::int64_t>(reach)];
  }
  run_forwards(filter, padded);
  std::reverse(padded.begin(), padded.end());
  run_forwards(filter, padded);
  std::reverse(padded.begin(), padded.end());
  std::copy_n(padded.begin() + static_cast<std::ptrdiff_t>(reach), samples.size(), samples.begin());
}

}  // namespace

ButterworthCoefficients make_butterworth(double cutoff_hz, double rate_hz, int passes) {
  const double correction = std::pow(std::pow(2.0, 1.0 / passes) - 1.0, 0.25);
  const double omega = std::tan(std::numbers::pi * cutoff_hz / rate_hz) / correction;
  const double k1 = std::numbers::sqrt2 * omega;
  const double k2 = omega * omega;
  const double a0 = k2 / (1.0 + k1 + k2);
  const double k3 = 2.0 * a0 / k2;
  return {a0, 2.0 * a0, a0, k3 - 2.0 * a0, 1.0 - 2.0 * a0 - k3};
}

double butterworth_gain(const ButterworthCoefficients& filter, double frequency_hz, double rate_hz) {
  const std::complex<double> z = std::polar(1.0, -2.0 * std::numbers::pi * frequency_hz / rate_hz);
  return std::abs((filter.a0 + filter.a1 * z + filter.a2 * z * z) / (1.0 - filter.b1 * z - filter.b2 * z * z));
}

void compute_butterworth(std::span<const double> curve, double cutoff_hz, double rate_hz, std::span<double> filtered) {
  std::copy(curve.begin(), curve.end(), filtered.begin());
  const FrameRange frames = find_finite_frames(curve);
  if (frames.count < 3) return;
  std::vector<double> samples = bridged(curve, frames);
  // The filter lets straight lines pass, so the line through the ends can go around it.
  const double start = samples.front();
  const double slope = (samples.back() - start) / (frames.count - 1);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] -= start + slope * static_cast<double>(i);
  samples.back() = 0.0;
  const double reach = std::min(kPeriodsToForget * rate_hz / cutoff_hz, kMostLengths * frames.count);
  filter_both_ways(make_butterworth(cutoff_hz, rate_hz, 2), static_cast<std::size_t>(std::ceil(reach)), samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    filtered[idx(frames.first) + i] = start + slope * static_cast<double>(i) + samples[i];
  }
  keep_missing(curve, filtered);
}

}  // namespace marey
