#include "core/signal/residual_analysis.h"

#include <algorithm>
#include <cmath>

#include "core/signal/butterworth.h"
#include "core/signal/continued_curve.h"

namespace marey {
namespace {

constexpr int kSteps = 100;
constexpr int kLastStep = 90;
constexpr int kLeastFrames = 10;

double compute_residual(std::span<const double> curve, std::span<const double> filtered) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!std::isfinite(curve[i])) continue;
    sum += (curve[i] - filtered[i]) * (curve[i] - filtered[i]);
    ++count;
  }
  return count > 0 ? std::sqrt(sum / count) : 0.0;
}

void fit_noise_line(double from_hz, double to_hz, ResidualAnalysis& analysis) {
  double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0, syy = 0.0;
  for (const auto& [x, y] : analysis.residuals) {
    if (x < from_hz || x > to_hz) continue;
    n += 1.0;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
    syy += y * y;
  }
  const double spread = n * sxx - sx * sx;
  if (n < 3.0 || spread <= 0.0) return;
  analysis.slope_per_hz = (n * sxy - sx * sy) / spread;
  analysis.noise_rms = (sy - analysis.slope_per_hz * sx) / n;
  const double height = n * syy - sy * sy;
  if (height > 0.0) analysis.r_squared = (n * sxy - sx * sy) * (n * sxy - sx * sy) / (spread * height);
}

// The residuals fall as the cut-off rises: between which two they pass the noise.
double find_cutoff(const ResidualAnalysis& analysis) {
  const std::vector<Residual>& residuals = analysis.residuals;
  if (!(analysis.noise_rms > 0.0)) return 0.0;
  for (std::size_t i = 1; i < residuals.size(); ++i) {
    const double above = residuals[i - 1].rms - analysis.noise_rms;
    const double below = residuals[i].rms - analysis.noise_rms;
    if (above < 0.0 || below > 0.0) continue;
    const double share = above > below ? above / (above - below) : 0.0;
    return residuals[i - 1].cutoff_hz + share * (residuals[i].cutoff_hz - residuals[i - 1].cutoff_hz);
  }
  return 0.0;
}

}  // namespace

ResidualAnalysis analyse_residuals(std::span<const double> curve, double rate_hz, NoiseBand band) {
  ResidualAnalysis analysis;
  if (find_finite_frames(curve).count < kLeastFrames || !(rate_hz > 0.0) || !std::isfinite(rate_hz)) return analysis;
  std::vector<double> filtered(curve.size());
  for (int step = 1; step <= kLastStep; ++step) {
    const double cutoff_hz = 0.5 * rate_hz * step / kSteps;
    compute_butterworth(curve, cutoff_hz, rate_hz, filtered);
    analysis.residuals.push_back({cutoff_hz, compute_residual(curve, filtered)});
  }
  fit_noise_line(band.from * 0.5 * rate_hz, band.to * 0.5 * rate_hz, analysis);
  analysis.cutoff_hz = find_cutoff(analysis);
  return analysis;
}

}  // namespace marey
