#include "tests/mujoco/deviations.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iostream>

namespace marey::test {
namespace {

// Unlike std::max() it keeps what is not a number.
double larger(double a, double b) { return std::isnan(a) || a > b ? a : b; }

}  // namespace

void Spread::add(const glm::dvec3& a, const glm::dvec3& b) {
  difference_ = larger(difference_, glm::length(a - b));
  widen(glm::length(a));
}

void Spread::widen(double size) { size_ = larger(size_, size); }

std::vector<Deviations::Entry>::const_iterator Deviations::find(std::string_view quantity) const {
  return std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.quantity == quantity; });
}

void Deviations::add(const std::string& quantity, double deviation, int which_case) {
  const auto place = find(quantity) - entries_.begin();
  if (find(quantity) == entries_.end()) entries_.push_back({quantity, 0.0, which_case});
  Entry& entry = entries_[static_cast<std::size_t>(place)];
  if (larger(entry.largest, deviation) != entry.largest && !std::isnan(entry.largest)) entry = {quantity, deviation, which_case};
}

double Deviations::largest(std::string_view quantity) const {
  const auto found = find(quantity);
  return found == entries_.end() ? 0.0 : found->largest;
}

std::string Deviations::describe() const {
  std::string text;
  for (const Entry& entry : entries_) text += fmt::format("{}{} {:.1e}", text.empty() ? "" : ", ", entry.quantity, entry.largest);
  return text;
}

void report(std::string_view what, const Deviations& deviations) {
  std::cout << fmt::format("largest deviations from MuJoCo, {}: {}\n", what, deviations.describe());
}

void expect_at_most(const Deviations& deviations, double most) {
  EXPECT_FALSE(deviations.entries().empty());
  for (const Deviations::Entry& entry : deviations.entries()) {
    EXPECT_LE(entry.largest, most) << entry.quantity << " in case " << entry.worst_case;
  }
}

}  // namespace marey::test
