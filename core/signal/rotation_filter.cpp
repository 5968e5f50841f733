#include "core/signal/rotation_filter.h"

#include <algorithm>
#include <cmath>

#include "core/base/index.h"

namespace marey {
namespace {

bool is_finite(const glm::dquat& q) {
  return std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
}

// The rotations from the first to the last finite one, and `reach` more on either side.
std::vector<glm::dquat> continued(std::span<const glm::dquat> rotations, int reach) {
  const int count = size_of(rotations);
  std::vector<glm::dquat> all(idx(count) + 2 * idx(reach));
  const glm::dquat first = rotations.front();
  const glm::dquat last = rotations.back();
  for (int i = 0; i < count; ++i) all[idx(reach + i)] = rotations[idx(i)];
  for (int k = 1; k <= reach; ++k) {
    all[idx(reach - k)] = first * glm::conjugate(rotations[idx(k)]) * first;
    all[idx(reach + count - 1 + k)] = last * glm::conjugate(rotations[idx(count - 1 - k)]) * last;
  }
  return all;
}

void give_one_sign(std::span<glm::dquat> rotations) {
  glm::dquat previous(1.0, 0.0, 0.0, 0.0);
  for (glm::dquat& q : rotations) {
    if (!is_finite(q)) continue;
    if (glm::dot(previous, q) < 0.0) q = -q;
    previous = q;
  }
}

}  // namespace

void filter_rotations(std::span<glm::dquat> rotations, int reach, const CurveFilter& filter) {
  std::size_t first = 0;
  std::size_t end = rotations.size();
  while (first < end && !is_finite(rotations[first])) ++first;
  while (end > first && !is_finite(rotations[end - 1])) --end;
  if (end - first < 2) return;
  const std::span<glm::dquat> moving = rotations.subspan(first, end - first);
  const int most = std::min(std::max(reach, 0), size_of(moving) - 1);
  std::vector<glm::dquat> all = continued(moving, most);
  give_one_sign(all);
  std::vector<double> component(all.size());
  std::vector<double> filtered(all.size());
  std::vector<glm::dquat> result(moving.begin(), moving.end());
  for (int c = 0; c < 4; ++c) {
    std::transform(all.begin(), all.end(), component.begin(), [c](const glm::dquat& q) { return q[c]; });
    filter(component, filtered);
    for (std::size_t i = 0; i < result.size(); ++i) result[i][c] = filtered[idx(most) + i];
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double length = glm::length(result[i]);
    if (is_finite(moving[i]) && length > 0.0) moving[i] = result[i] / length;
  }
}

}  // namespace marey
