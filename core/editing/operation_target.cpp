#include "core/editing/operation_target.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <utility>

namespace marey {
namespace {

// Sorted, without repeats, in [0, count).
void tidy(std::vector<int>& indices, int count) {
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  std::erase_if(indices, [count](int index) { return index < 0 || index >= count; });
}

// Of the frame that is `distance` frames from the outside of the range, 1 being the first inside.
double rising_weight(int distance, int blend_frames) {
  if (distance > blend_frames) return 1.0;
  return 0.5 * (1.0 - std::cos(std::numbers::pi * distance / (blend_frames + 1.0)));
}

}  // namespace

OperationTarget whole_clip(const Clip& clip) {
  OperationTarget target;
  target.channels.resize(idx(clip.motion.channel_count()));
  std::iota(target.channels.begin(), target.channels.end(), 0);
  target.joints.resize(idx(clip.skeleton.joint_count()));
  std::iota(target.joints.begin(), target.joints.end(), 0);
  target.frames = {0, clip.motion.frame_count()};
  return target;
}

OperationTarget target_of(const Clip& clip, std::vector<ChannelIndex> channels, FrameRange frames) {
  OperationTarget target;
  target.channels = std::move(channels);
  target.frames = frames;
  target = within_clip(clip, std::move(target));
  for (const ChannelIndex channel : target.channels) target.joints.push_back(clip.skeleton.channel(channel).joint);
  tidy(target.joints, clip.skeleton.joint_count());
  return target;
}

OperationTarget within_clip(const Clip& clip, OperationTarget target) {
  tidy(target.channels, clip.motion.channel_count());
  tidy(target.joints, clip.skeleton.joint_count());
  const std::int64_t end = std::int64_t{target.frames.first} + std::max(target.frames.count, 0);
  const FrameIndex first = std::clamp(target.frames.first, 0, clip.motion.frame_count());
  const auto last = static_cast<FrameIndex>(std::clamp<std::int64_t>(end, first, clip.motion.frame_count()));
  target.frames = {first, last - first};
  target.blend_in_frames = std::clamp(target.blend_in_frames, 0, target.frames.count);
  target.blend_out_frames = std::clamp(target.blend_out_frames, 0, target.frames.count);
  target.weight = target.weight > 0.0 ? std::min(target.weight, 1.0) : 0.0;
  return target;
}

std::vector<double> blend_weights(const OperationTarget& target) {
  const int count = target.frames.count;
  std::vector<double> weights(idx(count), target.weight);
  for (int i = 0; i < target.blend_in_frames; ++i) weights[idx(i)] *= rising_weight(i + 1, target.blend_in_frames);
  for (int i = 0; i < target.blend_out_frames; ++i) {
    weights[idx(count - 1 - i)] *= rising_weight(i + 1, target.blend_out_frames);
  }
  return weights;
}

}  // namespace marey
