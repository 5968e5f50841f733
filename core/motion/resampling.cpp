#include "core/motion/resampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/math/euler.h"
#include "core/motion/frame_time.h"
#include "core/motion/sampling.h"

namespace marey {
namespace {

// A time this near to a frame, in frames, is that frame: the ratio of two rates is rarely exact.
constexpr double kSameFrame = 1e-6;

Error invalid(std::string message) { return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; }

// The rotation channels of a joint that can be found back from a rotation.
struct EulerChannels {
  EulerOrder order;
  int count = 0;  // 2 or 3; with two, the third axis of `order` has no channel
  ChannelIndex channels[3] = {};
};

Axis remaining_axis(Axis a, Axis b) { return static_cast<Axis>(3 - static_cast<int>(a) - static_cast<int>(b)); }

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

void resample_rotation(const Skeleton& skeleton, const Motion& source, JointIndex joint, const EulerChannels& euler,
                       std::span<const FrameBlend> times, Motion& target) {
  for (FrameIndex frame = 0; frame < size_of(times); ++frame) {
    const FrameBlend& at = times[idx(frame)];
    const FrameIndex nearest = at.weight > 0.5 ? at.next : at.frame;
    glm::dvec3 angles_deg(0.0);
    for (int i = 0; i < euler.count; ++i) angles_deg[i] = source.sample(euler.channels[i], nearest);
    if (at.weight > 0.0) {
      const glm::dmat3 rotation = glm::mat3_cast(joint_rotation(skeleton, source, joint, at));
      angles_deg = euler_near(euler.order, rotation, angles_deg);
    }
    for (int i = 0; i < euler.count; ++i) target.channel_samples(euler.channels[i])[idx(frame)] = angles_deg[i];
  }
}

void resample_linearly(const Motion& source, ChannelIndex channel, std::span<const FrameBlend> times, Motion& target) {
  const std::span<double> samples = target.channel_samples(channel);
  for (FrameIndex frame = 0; frame < size_of(times); ++frame) {
    samples[idx(frame)] = sample_at(source, channel, times[idx(frame)]);
  }
}

// Where the new frames lie between the old ones.
std::vector<FrameBlend> new_times(const Motion& source, double old_rate_hz, double new_rate_hz, int new_count) {
  std::vector<FrameBlend> times;
  times.reserve(idx(new_count));
  for (FrameIndex frame = 0; frame < new_count; ++frame) {
    const double old_frame = frame * old_rate_hz / new_rate_hz;
    const double whole = std::round(old_frame);
    times.push_back(find_frame_blend(source.frame_count(), std::abs(old_frame - whole) < kSameFrame ? whole : old_frame));
  }
  return times;
}

}  // namespace

Motion trimmed(const Motion& motion, FrameRange range) {
  const FrameIndex first = std::clamp(range.first, 0, motion.frame_count());
  const int count = std::clamp(range.end() - first, 0, motion.frame_count() - first);
  Motion part(motion.channel_count(), count, motion.frame_time_s());
  for (ChannelIndex channel = 0; channel < motion.channel_count(); ++channel) {
    const std::span<const double> samples = motion.channel_samples(channel).subspan(idx(first), idx(count));
    std::copy(samples.begin(), samples.end(), part.channel_samples(channel).begin());
  }
  return part;
}

Result<Motion> resampled(const Skeleton& skeleton, const Motion& motion, double new_rate_hz) {
  if (!(new_rate_hz > 0.0) || !std::isfinite(new_rate_hz)) {
    return invalid("The new frame rate must be a number above 0.");
  }
  if (!is_frame_time(1.0 / new_rate_hz)) {
    return invalid(fmt::format("The new frame rate must be above {} per second.", 1.0 / kFrameTimeEndS));
  }
  const double old_rate_hz = display_frame_rate_hz(motion.frame_time_s());
  const double last_frame = std::max(motion.frame_count() - 1, 0) * new_rate_hz / old_rate_hz;
  if ((last_frame + 1.0) * std::max(motion.channel_count(), 1) > kMaxResampledSamples) {
    return invalid("The new frame rate gives more samples than fit in memory.");
  }
  if (motion.frame_count() == 0 || std::abs(new_rate_hz / old_rate_hz - 1.0) < 1e-9) return motion;

  const int new_count = static_cast<int>(last_frame + kSameFrame) + 1;
  const std::vector<FrameBlend> times = new_times(motion, old_rate_hz, new_rate_hz, new_count);
  Motion target(motion.channel_count(), new_count, 1.0 / new_rate_hz);
  for (ChannelIndex channel = 0; channel < motion.channel_count(); ++channel) {
    resample_linearly(motion, channel, times, target);
  }
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const std::optional<EulerChannels> euler = find_euler_channels(skeleton, joint);
    if (euler) resample_rotation(skeleton, motion, joint, *euler, times, target);
  }
  return target;
}

}  // namespace marey
