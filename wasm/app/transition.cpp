#include "wasm/app/transition.h"

#include <algorithm>

namespace marey::app {
namespace {
constexpr double kDuration_s = 0.12;
}

bool Transition::advance(bool target, double elapsed_s, bool at_once) {
  const double goal = target ? 1.0 : 0.0;
  if (!started_ || at_once) progress_ = goal;
  started_ = true;
  const double step = elapsed_s / kDuration_s;
  progress_ = goal > progress_ ? std::min(goal, progress_ + step) : std::max(goal, progress_ - step);
  return progress_ != goal;
}

float Transition::share() const {
  const double left = 1.0 - progress_;
  return static_cast<float>(1.0 - left * left);
}

}  // namespace marey::app
