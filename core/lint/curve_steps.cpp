#include "core/lint/curve_steps.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/motion/sampling.h"

namespace marey::lint {
namespace {

/// Reorders `values`; 0 when there are none.
double median_of(std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

bool is_recording(const Motion& motion) {
  return motion.frame_count() >= kLeastFrames && motion.frame_time_s() <= kLongestFrameTime_s;
}

int frames_in(const Motion& motion, double duration_s, int least) {
  const double frames = std::ceil(duration_s / motion.frame_time_s() - 1e-6);
  return std::max(least, static_cast<int>(std::min(frames, static_cast<double>(motion.frame_count()) + 1.0)));
}

double turn_between_deg(const Clip& clip, JointIndex joint, FrameIndex a, FrameIndex b) {
  const glm::dquat from = joint_rotation(clip.skeleton, clip.motion, joint, a);
  const glm::dquat to = joint_rotation(clip.skeleton, clip.motion, joint, b);
  const double cosine = std::abs(glm::dot(from, to));
  return std::isfinite(cosine) ? 2.0 * std::acos(std::min(cosine, 1.0)) * 180.0 / glm::pi<double>() : 180.0;
}

void CurveSteps::load(const Clip& clip, ChannelIndex channel, FrameRange frames) {
  const auto samples = clip.motion.channel_samples(channel).subspan(idx(frames.first), idx(frames.count));
  const bool turns = is_rotation(clip.skeleton.channel(channel).kind);
  steps_.resize(samples.empty() ? 0 : samples.size() - 1);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const double step = samples[i + 1] - samples[i];
    steps_[i] = !std::isfinite(step) ? 0.0 : turns && std::abs(step) > 180.0 ? std::remainder(step, 360.0) : step;
  }
}

double CurveSteps::compute_usual_change() {
  scratch_.clear();
  for (std::size_t i = 1; i < steps_.size(); ++i) scratch_.push_back(std::abs(steps_[i] - steps_[i - 1]));
  return median_of(scratch_);
}

double CurveSteps::compute_neighbour_step(int i, int count) {
  scratch_.clear();
  const int end = std::min(size_of(steps_), i + count + kNeighbours);
  for (int other = std::max(0, i - kNeighbours); other < end; ++other) {
    if (other < i || other >= i + count) scratch_.push_back(std::abs(steps_[idx(other)]));
  }
  return median_of(scratch_);
}

}  // namespace marey::lint
