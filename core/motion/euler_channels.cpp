#include "core/motion/euler_channels.h"

#include <vector>

namespace marey {
namespace {

Axis remaining_axis(Axis a, Axis b) { return static_cast<Axis>(3 - static_cast<int>(a) - static_cast<int>(b)); }

}  // namespace

std::optional<EulerChannels> find_euler_channels(const Skeleton& skeleton, JointIndex joint) {
  EulerChannels found;
  std::vector<Axis> axes;
  ChannelIndex index = skeleton.first_channel(joint);
  for (const Channel& channel : skeleton.channels(joint)) {
    if (is_rotation(channel.kind)) {
      if (axes.size() == 3) return std::nullopt;
      found.channels[axes.size()] = index;
      axes.push_back(axis_of(channel.kind));
    }
    ++index;
  }
  found.count = size_of(axes);
  if (found.count == 2 && axes[0] != axes[1]) axes.push_back(remaining_axis(axes[0], axes[1]));
  const std::optional<EulerOrder> order = find_euler_order(axes);
  if (!order) return std::nullopt;
  found.order = *order;
  return found;
}

glm::dvec3 angles_deg_of(const Motion& motion, const EulerChannels& euler, FrameIndex frame) {
  glm::dvec3 angles_deg(0.0);
  for (int i = 0; i < euler.count; ++i) angles_deg[i] = motion.sample(euler.channels[i], frame);
  return angles_deg;
}

}  // namespace marey
