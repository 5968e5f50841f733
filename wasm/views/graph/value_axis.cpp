#include "wasm/views/graph/value_axis.h"

#include <algorithm>
#include <cmath>

namespace marey::app {
namespace {

constexpr double kShortestHeight = 1e-6;
constexpr double kLongestHeight = 1e9;

}  // namespace

float ValueAxis::y_of(double value) const {
  // Far outside of the view a float would overflow in the draw list; the line's direction is all that matters there.
  const double share = std::clamp((value - low) / (high - low), -1e3, 1e3);
  return bottom - static_cast<float>(share) * (bottom - top);
}

double ValueAxis::value_at(float y) const {
  return low + static_cast<double>((bottom - y) / (bottom - top)) * (high - low);
}

void ValueAxis::zoom(float y, double factor) {
  const double about = value_at(y);
  const double share = (about - low) / (high - low);
  const double height = std::clamp((high - low) * factor, kShortestHeight, kLongestHeight);
  low = about - share * height;
  high = low + height;
}

void ValueAxis::pan(double values) {
  low += values;
  high += values;
}

void ValueAxis::fit(double lowest, double highest, double least_height) {
  const double height = std::max(highest - lowest, least_height);
  const double middle = 0.5 * (lowest + highest);
  low = middle - 0.6 * height;
  high = middle + 0.6 * height;
}

void ValueRange::add(double value) {
  if (!std::isfinite(value)) return;
  low = empty ? value : std::min(low, value);
  high = empty ? value : std::max(high, value);
  empty = false;
}

void ValueRange::add(std::span<const double> values) {
  for (const double value : values) add(value);
}

}  // namespace marey::app
