#include "core/kinematics/clip_bounds.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <vector>

#include "core/kinematics/forward_kinematics.h"

namespace marey {
namespace {

constexpr int kPostureSamples = 64;

// World positions of single frames spread evenly over a clip, one frame at a time.
class SampledFrames {
 public:
  SampledFrames(const Skeleton& skeleton, const Motion& motion, PositionRule rule, int max_samples)
      : skeleton_(skeleton),
        motion_(motion),
        rule_(rule),
        count_(std::min(motion.frame_count(), std::max(max_samples, 2))),
        positions_(idx(skeleton.node_count()) * 3) {}

  [[nodiscard]] int count() const { return count_; }

  // Box around the nodes that are finite; nothing is finite: low > high.
  [[nodiscard]] Box box(int sample) {
    compute_world_positions(skeleton_, motion_, {frame_of(sample), 1}, rule_, std::span(positions_));
    Box box{glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL)};
    for (std::size_t i = 0; i < positions_.size(); i += 3) {
      const glm::dvec3 p(positions_[i], positions_[i + 1], positions_[i + 2]);
      if (!std::isfinite(p.x + p.y + p.z)) continue;
      box = {glm::min(box.low, p), glm::max(box.high, p)};
    }
    return box;
  }

 private:
  [[nodiscard]] FrameIndex frame_of(int sample) const {
    if (count_ < 2) return 0;
    return static_cast<FrameIndex>(std::int64_t{sample} * (motion_.frame_count() - 1) / (count_ - 1));
  }

  const Skeleton& skeleton_;
  const Motion& motion_;
  PositionRule rule_;
  int count_;
  std::vector<double> positions_;
};

}  // namespace

Box compute_clip_bounds(const Skeleton& skeleton, const Motion& motion, PositionRule rule, int max_samples) {
  SampledFrames frames(skeleton, motion, rule, max_samples);
  Box bounds{glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL)};
  for (int i = 0; i < frames.count(); ++i) {
    const Box box = frames.box(i);
    bounds = {glm::min(bounds.low, box.low), glm::max(bounds.high, box.high)};
  }
  return bounds.low.x <= bounds.high.x ? bounds : Box{};
}

Axis find_up_axis(const Skeleton& skeleton, const Motion& motion, PositionRule rule) {
  SampledFrames frames(skeleton, motion, rule, kPostureSamples);
  glm::dvec3 extent(0.0);
  for (int i = 0; i < frames.count(); ++i) {
    const Box box = frames.box(i);
    if (box.low.x <= box.high.x) extent += box.size();
  }
  return extent.z > extent.y ? Axis::Z : Axis::Y;
}

double find_ground_height(const Skeleton& skeleton, const Motion& motion, PositionRule rule, Axis up) {
  SampledFrames frames(skeleton, motion, rule, kPostureSamples);
  std::vector<double> lowest;
  for (int i = 0; i < frames.count(); ++i) {
    const Box box = frames.box(i);
    if (box.low.x <= box.high.x) lowest.push_back(box.low[static_cast<int>(up)]);
  }
  if (lowest.empty()) return 0.0;
  const auto low = lowest.begin() + static_cast<std::ptrdiff_t>(lowest.size() / 20);
  std::nth_element(lowest.begin(), low, lowest.end());
  return *low;
}

}  // namespace marey
