#include "core/kinematics/clip_bounds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <vector>

#include "core/kinematics/pose.h"

namespace marey {
namespace {

constexpr int kPostures = 64;
constexpr Box kNoBox{glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL)};

bool is_empty(const Box& box) { return box.low.x > box.high.x; }

Box joined(const Box& a, const Box& b) { return {glm::min(a.low, b.low), glm::max(a.high, b.high)}; }

// Box around the points that are finite; kNoBox when there are none.
Box box_around(const std::vector<glm::dvec3>& points) {
  Box box = kNoBox;
  for (const glm::dvec3& p : points) {
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) box = joined(box, {p, p});
  }
  return box;
}

// Boxes around single poses.
class PostureBoxes {
 public:
  explicit PostureBoxes(const Skeleton& skeleton) : skeleton_(skeleton) {
    local_.resize(skeleton);
    world_.resize(skeleton);
  }

  [[nodiscard]] Box at_rest() {
    compute_rest_pose(skeleton_, local_);
    compute_world_pose(skeleton_, local_, world_);
    return box_around(world_.world_positions);
  }

  [[nodiscard]] Box at_frame(const Motion& motion, FrameIndex frame, PositionRule rule) {
    compute_local_pose(skeleton_, motion, frame, rule, local_);
    compute_world_pose(skeleton_, local_, world_);
    return box_around(world_.world_positions);
  }

  // The boxes of at most `count` frames spread evenly over the clip, without empty ones.
  [[nodiscard]] std::vector<Box> spread(const Motion& motion, PositionRule rule, int count) {
    std::vector<Box> boxes;
    const int last = motion.frame_count() - 1;
    const int steps = std::clamp(count - 1, 0, std::max(last, 0));
    for (int i = 0; i <= steps && last >= 0; ++i) {
      const auto frame = steps == 0 ? 0 : static_cast<FrameIndex>(std::int64_t{i} * last / steps);
      const Box box = at_frame(motion, frame, rule);
      if (!is_empty(box)) boxes.push_back(box);
    }
    return boxes;
  }

 private:
  const Skeleton& skeleton_;
  LocalPose local_;
  WorldPose world_;
};

// The lower ends of boxes along an axis, in order.
std::vector<double> sorted_lows(const std::vector<Box>& boxes, int axis) {
  std::vector<double> lows;
  for (const Box& box : boxes) lows.push_back(box.low[axis]);
  std::sort(lows.begin(), lows.end());
  return lows;
}

// part 0: the least, 1: the greatest. `sorted` is not empty.
double percentile(const std::vector<double>& sorted, double part) {
  return sorted[static_cast<std::size_t>(std::lround(part * static_cast<double>(sorted.size() - 1)))];
}

// How much speaks for an axis as the vertical one, in statures.
double uprightness(const std::vector<Box>& frames, const Box& rest, int axis, double stature) {
  double height = rest.size()[axis];
  for (const Box& box : frames) height += box.size()[axis];
  height /= static_cast<double>(frames.size() + 1) * stature;
  if (frames.empty()) return height;
  const bool stands_on_zero = std::abs(percentile(sorted_lows(frames, axis), 0.5)) < 0.05 * stature;
  return stands_on_zero && height > 0.3 ? height + 1.0 : height;
}

bool has_root_at_origin(const Skeleton& skeleton, const Motion& motion, PositionRule rule) {
  LocalPose local;
  local.resize(skeleton);
  std::vector<bool> is_away(idx(skeleton.joint_count()));
  for (FrameIndex frame : {0, motion.frame_count() / 2, motion.frame_count() - 1}) {
    compute_local_pose(skeleton, motion, frame, rule, local);
    for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
      if (local.local_translations[idx(joint)] != glm::dvec3(0.0)) is_away[idx(joint)] = true;
    }
  }
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    if (skeleton.parent(joint) == kNoParent && !is_away[idx(joint)]) return true;
  }
  return false;
}

}  // namespace

Box compute_clip_bounds(const Skeleton& skeleton, const Motion& motion, PositionRule rule, int max_samples) {
  PostureBoxes postures(skeleton);
  Box bounds = kNoBox;
  for (const Box& box : postures.spread(motion, rule, std::max(max_samples, 2))) bounds = joined(bounds, box);
  return is_empty(bounds) ? postures.at_rest() : bounds;
}

Axis find_up_axis(const Skeleton& skeleton, const Motion& motion, PositionRule rule) {
  const double stature = compute_stature(skeleton);
  if (!(stature > 0.0)) return Axis::Y;
  PostureBoxes postures(skeleton);
  const std::vector<Box> frames = postures.spread(motion, rule, kPostures);
  const Box rest = postures.at_rest();
  return uprightness(frames, rest, 2, stature) > uprightness(frames, rest, 1, stature) ? Axis::Z : Axis::Y;
}

double find_ground_height(const Skeleton& skeleton, const Motion& motion, PositionRule rule, Axis up) {
  PostureBoxes postures(skeleton);
  const double stature = compute_stature(skeleton);
  std::vector<Box> boxes = postures.spread(motion, rule, kPostures);
  const bool has_frames = !boxes.empty();
  if (!has_frames) boxes.push_back(postures.at_rest());

  const std::vector<double> lows = sorted_lows(boxes, static_cast<int>(up));
  const double ground = percentile(lows, 0.05);
  const bool about_zero = ground >= -0.005 * stature && ground <= 0.03 * stature;
  const bool swings = percentile(lows, 0.95) - ground > 0.25 * stature;
  if (about_zero || (swings && has_frames && has_root_at_origin(skeleton, motion, rule))) return 0.0;
  return ground;
}

}  // namespace marey
