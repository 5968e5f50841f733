#include "core/motion/sampling.h"

#include <algorithm>

#include "core/math/axis_turn.h"

namespace marey {
namespace {

int rotation_channel_count(const Skeleton& skeleton, JointIndex joint) {
  const auto channels = skeleton.channels(joint);
  return static_cast<int>(
      std::count_if(channels.begin(), channels.end(), [](const Channel& c) { return is_rotation(c.kind); }));
}

template <class AngleOf>
glm::dquat rotation_of_channels(const Skeleton& skeleton, JointIndex joint, AngleOf angle_deg_of) {
  glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
  ChannelIndex index = skeleton.first_channel(joint);
  for (const Channel& channel : skeleton.channels(joint)) {
    if (is_rotation(channel.kind)) {
      rotation = turned_about(rotation, axis_of(channel.kind), sincos_deg(0.5 * angle_deg_of(index)));
    }
    ++index;
  }
  return rotation;
}

}  // namespace

FrameBlend find_frame_blend(int frame_count, double frame) {
  const double last = frame_count - 1;
  // Written so that NaN becomes the first frame.
  const double clamped = frame > 0.0 ? std::min(frame, last) : 0.0;
  const auto whole = static_cast<FrameIndex>(clamped);
  const double weight = clamped - whole;
  return {whole, weight > 0.0 ? whole + 1 : whole, weight};
}

double sample_at(const Motion& motion, ChannelIndex channel, const FrameBlend& at) {
  const double from = motion.sample(channel, at.frame);
  return at.weight > 0.0 ? from + at.weight * (motion.sample(channel, at.next) - from) : from;
}

glm::dquat joint_rotation(const Skeleton& skeleton, const Motion& motion, JointIndex joint, FrameIndex frame) {
  return rotation_of_channels(skeleton, joint,
                              [&](ChannelIndex channel) { return motion.sample(channel, frame); });
}

glm::dquat joint_rotation(const Skeleton& skeleton, const Motion& motion, JointIndex joint, const FrameBlend& at) {
  if (at.weight == 0.0) return joint_rotation(skeleton, motion, joint, at.frame);
  if (rotation_channel_count(skeleton, joint) <= 1) {
    return rotation_of_channels(skeleton, joint, [&](ChannelIndex channel) { return sample_at(motion, channel, at); });
  }
  const glm::dquat from = joint_rotation(skeleton, motion, joint, at.frame);
  const glm::dquat to = joint_rotation(skeleton, motion, joint, at.next);
  return glm::normalize(glm::slerp(from, to, at.weight));
}

}  // namespace marey
