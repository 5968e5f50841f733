#include "core/signal/gaussian_smoothing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/signal/continued_curve.h"

namespace marey {
namespace {

constexpr double kKernelCutSigmas = 4.0;
constexpr std::size_t kBlock = 256;  // frames whose sums stay in the first cache while the kernel passes

std::vector<double> make_half_kernel(double sigma_frames) {
  std::vector<double> weights(static_cast<std::size_t>(kKernelCutSigmas * sigma_frames) + 1);
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const double z = static_cast<double>(k) / sigma_frames;
    weights[k] = std::exp(-0.5 * z * z);
  }
  return weights;
}

// `center` points at the first of `count` samples that have weights.size() - 1 neighbours on either side. Pairs of
// neighbours are taken relative to the sample between them, so that what is straight cancels without a rounding error
// that grows with the kernel.
void smooth_block(const double* center, std::size_t count, std::span<const double> weights, double* smoothed) {
  std::array<double, kBlock> shift{};
  std::array<double, kBlock> weight{};
  weight.fill(weights[0]);
  for (std::size_t k = 1; k < weights.size(); ++k) {
    const double* before = center - k;
    const double* behind = center + k;
    for (std::size_t i = 0; i < count; ++i) {
      const double pair = (before[i] - center[i]) + (behind[i] - center[i]);
      const bool counts = std::abs(pair) <= std::numeric_limits<double>::max();
      shift[i] += counts ? weights[k] * pair : 0.0;
      weight[i] += counts ? 2.0 * weights[k] : 0.0;
    }
  }
  for (std::size_t i = 0; i < count; ++i) smoothed[i] = center[i] + shift[i] / weight[i];
}

}  // namespace

void compute_gaussian_smoothed(std::span<const double> curve, FrameRange run, double sigma_frames,
                               std::span<double> smoothed) {
  if (run.count <= 0) return;
  const std::vector<double> weights = make_half_kernel(std::min(sigma_frames, static_cast<double>(curve.size())));
  const std::int64_t reach = std::ssize(weights) - 1;
  const ContinuedCurve continued(curve);
  std::vector<double> padded(idx(run.count) + 2 * static_cast<std::size_t>(reach));
  for (std::size_t i = 0; i < padded.size(); ++i) {
    padded[i] = continued[run.first - reach + static_cast<std::int64_t>(i)];
  }
  const double* center = padded.data() + reach;
  for (std::size_t done = 0; done < idx(run.count); done += kBlock) {
    const std::size_t count = std::min(kBlock, idx(run.count) - done);
    smooth_block(center + done, count, weights, smoothed.data() + done);
  }
  keep_missing(curve.subspan(idx(run.first), idx(run.count)), smoothed);
}

}  // namespace marey
