#include "wasm/views/graph/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace marey::app {
namespace {

constexpr int kMostTicks = 500;

double round_step(double least_step) {
  const double decade = std::pow(10.0, std::floor(std::log10(least_step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * decade >= least_step * (1.0 - 1e-9)) return factor * decade;
  }
  return 10.0 * decade;
}

}  // namespace

Ticks make_ticks(double low, double high, double least_step, bool whole) {
  if (!(high > low) || !(least_step > 0.0) || !std::isfinite(high - low)) return {};
  Ticks ticks;
  ticks.step = round_step(whole ? std::max(least_step, 1.0) : least_step);
  ticks.first = std::ceil(low / ticks.step) * ticks.step;
  ticks.count = static_cast<int>(std::min<double>(kMostTicks, std::floor((high - ticks.first) / ticks.step) + 1.0));
  ticks.decimals = std::max(0, static_cast<int>(-std::floor(std::log10(ticks.step) + 1e-9)));
  return ticks;
}

std::string tick_label(double value, int decimals) {
  const double half_digit = 0.5 * std::pow(10.0, -decimals);
  return fmt::format("{:.{}f}", std::abs(value) < half_digit ? 0.0 : value, decimals);
}

}  // namespace marey::app
