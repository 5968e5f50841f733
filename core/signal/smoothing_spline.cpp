#include "core/signal/smoothing_spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/index.h"

namespace marey {
namespace {

constexpr int kBand = 3;  // neighbours that an unknown has on either side

// In units of frames the spline is given by its third derivative, a sum of quadratic B-splines with coefficients u:
// (R + lambda Q'Q) u = Q'y and s = y - lambda Q u, where Q' takes third differences and R holds the products of the
// B-splines (Green and Silverman 1994, section 2.3, for m = 2).
constexpr std::array<double, kBand + 1> kProducts = {66.0 / 120.0, 26.0 / 120.0, 1.0 / 120.0, 0.0};
constexpr std::array<double, kBand + 1> kSquaredDifferences = {20.0, -15.0, 6.0, -1.0};
constexpr std::array<double, kBand + 1> kDifference = {-1.0, 3.0, -3.0, 1.0};

/// The symmetric band matrix as L D L', L with ones on its diagonal.
class BandFactors {
 public:
  BandFactors(int size, double lambda) : rows_(idx(size)) {
    for (int i = 0; i < size; ++i) factor_row(i, lambda);
  }

  [[nodiscard]] int size() const { return size_of(rows_); }

  /// Solves for one right side, in its place.
  void solve(std::vector<double>& x) const {
    for (int i = 0; i < size(); ++i) {
      for (int k = 1; k <= std::min(kBand, i); ++k) x[idx(i)] -= lower(i, k) * x[idx(i - k)];
    }
    for (int i = 0; i < size(); ++i) x[idx(i)] /= rows_[idx(i)][0];
    for (int i = size() - 1; i >= 0; --i) {
      for (int k = 1; k <= std::min(kBand, size() - 1 - i); ++k) x[idx(i)] -= lower(i + k, k) * x[idx(i + k)];
    }
  }

  /// Trace of the inverse times Q'Q, from the band of the inverse alone (Hutchinson and de Hoog 1985).
  [[nodiscard]] double trace_of_inverse_times_squared_differences() const {
    const int n = size();
    std::vector<std::array<double, kBand + 1>> inverse(idx(n) + kBand);  // [i][k] = inverse(i, i + k)
    double trace = 0.0;
    for (int i = n - 1; i >= 0; --i) {
      const auto at = [&](int a, int b) { return inverse[idx(std::min(a, b))][idx(std::abs(a - b))]; };
      for (int k = kBand; k >= 0; --k) {
        double sum = k == 0 ? 1.0 / rows_[idx(i)][0] : 0.0;
        for (int m = 1; m <= std::min(kBand, n - 1 - i); ++m) {
          if (i + k < n) sum -= lower(i + m, m) * at(i + k, i + m);
        }
        inverse[idx(i)][idx(k)] = i + k < n ? sum : 0.0;
      }
      trace += inverse[idx(i)][0] * kSquaredDifferences[0];
      for (int k = 1; k <= kBand; ++k) trace += 2.0 * inverse[idx(i)][idx(k)] * kSquaredDifferences[idx(k)];
    }
    return trace;
  }

 private:
  [[nodiscard]] double lower(int row, int left) const { return rows_[idx(row)][idx(left)]; }

  void factor_row(int i, double lambda) {
    auto& row = rows_[idx(i)];
    for (int k = std::min(kBand, i); k >= 0; --k) {
      const int j = i - k;
      double sum = kProducts[idx(k)] + lambda * kSquaredDifferences[idx(k)];
      for (int m = k + 1; m <= std::min(kBand, i); ++m) {
        const int p = i - m;
        if (j - p <= kBand && j > p) sum -= row[idx(m)] * rows_[idx(p)][0] * lower(j, j - p);
      }
      row[idx(k)] = k == 0 ? sum : sum / rows_[idx(j)][0];
    }
  }

  std::vector<std::array<double, kBand + 1>> rows_;  // [0] of D, [k] of L, k to the left
};

/// In units of frames.
struct Fit {
  std::vector<double> values;
  std::vector<double> third;  // coefficients of the B-splines
  double freedom = 0.0;
  double residual = 0.0;  // sum of squares
};

Fit solve(std::span<const double> curve, double lambda, bool wants_freedom) {
  const int n = size_of(curve);
  const BandFactors factors(n - kBand, lambda);
  Fit fit;
  fit.third.resize(idx(n - kBand));
  for (int i = 0; i < n - kBand; ++i) {
    for (int k = 0; k <= kBand; ++k) fit.third[idx(i)] += kDifference[idx(k)] * curve[idx(i + k)];
  }
  factors.solve(fit.third);
  fit.values.assign(curve.begin(), curve.end());
  for (int i = 0; i < n - kBand; ++i) {
    for (int k = 0; k <= kBand; ++k) fit.values[idx(i + k)] -= lambda * kDifference[idx(k)] * fit.third[idx(i)];
  }
  for (int i = 0; i < n; ++i) fit.residual += (curve[idx(i)] - fit.values[idx(i)]) * (curve[idx(i)] - fit.values[idx(i)]);
  if (wants_freedom) fit.freedom = n - lambda * factors.trace_of_inverse_times_squared_differences();
  return fit;
}

/// The third derivative from sample i to i + 1, c0 + c1 t + c2 t^2 for t in 0 ... 1.
std::array<double, 3> third_derivative(const std::vector<double>& third, int i) {
  // The B-spline that begins at sample j is the one of the differences j ... j + 3.
  const auto u = [&](int j) { return j >= 0 && j < size_of(third) ? third[idx(j)] : 0.0; };
  const double a = u(i - 2);
  const double b = u(i - 1);
  const double c = u(i);
  return {0.5 * (a + b), b - a, 0.5 * (a - 2.0 * b + c)};
}

/// Integral of (1 - t)^2 / 2 s'''(t) from sample i to i + 1: what the Taylor polynomial at i lacks at i + 1.
double rest_ahead(const std::array<double, 3>& c) { return c[0] / 6.0 + c[1] / 24.0 + c[2] / 60.0; }

/// The same from sample i + 1 back to i.
double rest_behind(const std::array<double, 3>& c) { return c[0] / 6.0 + c[1] / 8.0 + c[2] / 10.0; }

void add_derivatives(const Fit& fit, double rate_hz, SplineFit& result) {
  const int n = size_of(fit.values);
  const std::vector<double>& s = fit.values;
  std::vector<double>& first = result.first;
  std::vector<double>& second = result.second;
  first.resize(idx(n));
  second.resize(idx(n));
  for (int i = 1; i + 1 < n; ++i) {
    const double ahead = rest_ahead(third_derivative(fit.third, i));
    const double behind = rest_behind(third_derivative(fit.third, i - 1));
    first[idx(i)] = 0.5 * (s[idx(i + 1)] - s[idx(i - 1)] - ahead - behind);
    second[idx(i)] = s[idx(i + 1)] + s[idx(i - 1)] - 2.0 * s[idx(i)] - ahead + behind;
  }
  const auto begin = third_derivative(fit.third, 0);
  const auto end = third_derivative(fit.third, n - 2);
  second[0] = second[1] - (begin[0] + begin[1] / 2.0 + begin[2] / 3.0);
  first[0] = first[1] - second[0] - (begin[0] / 2.0 + begin[1] / 6.0 + begin[2] / 12.0);
  second[idx(n - 1)] = second[idx(n - 2)] + end[0] + end[1] / 2.0 + end[2] / 3.0;
  first[idx(n - 1)] = first[idx(n - 2)] + second[idx(n - 2)] + end[0] / 2.0 + end[1] / 6.0 + end[2] / 12.0;
  for (double& value : first) value *= rate_hz;
  for (double& value : second) value *= rate_hz * rate_hz;
}

/// Generalised cross-validation for a lambda in units of frames.
double validation(std::span<const double> curve, const Fit& fit) {
  const double n = static_cast<double>(curve.size());
  const double left = n - fit.freedom;
  if (left <= 1e-9 * n) return std::numeric_limits<double>::infinity();
  return n * fit.residual / (left * left);
}

// Of lambda in units of frames, to the base of ten: from a curve through all samples to a parabola.
constexpr double kLeastExponent = -8.0;
constexpr double kMostExponent = 12.0;

/// Where a function of log10(lambda) is least, by a coarse look and golden sections about the best place.
template <class Function>
double least_of(const Function& function) {
  constexpr double kStep = 0.5;
  double best = kLeastExponent;
  double least = function(kLeastExponent);
  for (double at = kLeastExponent + kStep; at <= kMostExponent; at += kStep) {
    const double value = function(at);
    if (value < least) {
      least = value;
      best = at;
    }
  }
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = best - kStep;
  double high = best + kStep;
  while (high - low > 1e-4) {
    const double left = high - golden * (high - low);
    const double right = low + golden * (high - low);
    (function(left) < function(right) ? high : low) = function(left) < function(right) ? right : left;
  }
  return 0.5 * (low + high);
}

}  // namespace

SplineFit fit_smoothing_spline(std::span<const double> curve, double rate_hz, double lambda) {
  const double per_frame = lambda * std::pow(rate_hz, 5.0);
  Fit fit = solve(curve, per_frame, true);
  SplineFit result;
  result.smoothing = lambda;
  result.freedom = fit.freedom;
  result.gcv = validation(curve, fit);
  add_derivatives(fit, rate_hz, result);
  result.values = std::move(fit.values);
  return result;
}

SplineFit fit_smoothing_spline(std::span<const double> curve, double rate_hz, std::optional<double> noise_rms) {
  const double wanted = noise_rms ? *noise_rms * *noise_rms * static_cast<double>(curve.size()) : 0.0;
  const double exponent = least_of([&](double log10_lambda) {
    const Fit fit = solve(curve, std::pow(10.0, log10_lambda), !noise_rms);
    return noise_rms ? std::abs(fit.residual - wanted) : validation(curve, fit);
  });
  return fit_smoothing_spline(curve, rate_hz, std::pow(10.0, exponent) / std::pow(rate_hz, 5.0));
}

double find_smoothing_for_residual(std::span<const std::vector<double>> curves, double rate_hz, double residual) {
  double low = kLeastExponent;
  double high = kMostExponent;
  // What is left over grows with lambda.
  while (high - low > 1e-4) {
    const double middle = 0.5 * (low + high);
    double left = 0.0;
    for (const std::vector<double>& curve : curves) left += solve(curve, std::pow(10.0, middle), false).residual;
    (left < residual ? low : high) = middle;
  }
  return std::pow(10.0, 0.5 * (low + high)) / std::pow(rate_hz, 5.0);
}

}  // namespace marey
