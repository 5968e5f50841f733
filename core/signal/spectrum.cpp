#include "core/signal/spectrum.h"

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>

#include "core/signal/continued_curve.h"

namespace marey {
namespace {

using Complex = std::complex<double>;

void order_by_reversed_bits(std::vector<Complex>& values) {
  for (std::size_t i = 1, j = 0; i < values.size(); ++i) {
    std::size_t bit = values.size() >> 1;
    for (; (j & bit) != 0; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(values[i], values[j]);
  }
}

// Fast Fourier transform in place (Cooley and Tukey 1965); the size is a power of two.
void transform(std::vector<Complex>& values) {
  order_by_reversed_bits(values);
  for (std::size_t length = 2; length <= values.size(); length *= 2) {
    const std::size_t half = length / 2;
    std::vector<Complex> turns(half);
    for (std::size_t k = 0; k < half; ++k) {
      turns[k] = std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(length));
    }
    for (std::size_t start = 0; start < values.size(); start += length) {
      for (std::size_t k = 0; k < half; ++k) {
        const Complex a = values[start + k];
        const Complex b = values[start + k + half] * turns[k];
        values[start + k] = a + b;
        values[start + k + half] = a - b;
      }
    }
  }
}

void take_line_out(std::vector<double>& samples) {
  const double n = static_cast<double>(samples.size());
  const double middle = 0.5 * (n - 1.0);
  double mean = 0.0;
  double rise = 0.0;
  double spread = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double x = static_cast<double>(i) - middle;
    mean += samples[i] / n;
    rise += x * samples[i];
    spread += x * x;
  }
  const double slope = spread > 0.0 ? rise / spread : 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] -= mean + slope * (static_cast<double>(i) - middle);
}

}  // namespace

Spectrum compute_spectrum(std::span<const double> curve, double rate_hz) {
  const FrameRange frames = find_finite_frames(curve);
  if (frames.count < 4) return {};
  std::vector<double> samples = bridged(curve, frames);
  take_line_out(samples);
  std::size_t size = 4;
  while (size < samples.size()) size *= 2;
  std::vector<Complex> values(size);
  double weights = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double phase = 2.0 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(samples.size());
    const double weight = 0.5 * (1.0 - std::cos(phase));
    values[i] = samples[i] * weight;
    weights += weight;
  }
  transform(values);
  Spectrum spectrum;
  spectrum.step_hz = rate_hz / static_cast<double>(size);
  for (std::size_t k = 0; k <= size / 2; ++k) {
    const bool is_edge = k == 0 || k == size / 2;
    spectrum.amplitudes.push_back((is_edge ? 1.0 : 2.0) * std::abs(values[k]) / weights);
  }
  return spectrum;
}

}  // namespace marey
