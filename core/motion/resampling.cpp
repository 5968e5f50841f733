#include "core/motion/resampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/math/euler.h"
#include "core/motion/euler_channels.h"
#include "core/motion/frame_time.h"
#include "core/motion/sampling.h"

namespace marey {
namespace {

// A time this near to a frame, in frames, is that frame.
constexpr double kSameFrame = 1e-6;

Error invalid(std::string message) { return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; }

void resample_rotation(const Skeleton& skeleton, const Motion& source, JointIndex joint, const EulerChannels& euler,
                       std::span<const FrameBlend> times, Motion& target) {
  for (FrameIndex frame = 0; frame < size_of(times); ++frame) {
    const FrameBlend& at = times[idx(frame)];
    const FrameIndex nearest = at.weight > 0.5 ? at.next : at.frame;
    glm::dvec3 angles_deg = angles_deg_of(source, euler, nearest);
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

// Where the new frames lie between the old ones, counted in those.
std::vector<double> new_times(double old_rate_hz, double new_rate_hz, int new_count) {
  std::vector<double> times;
  times.reserve(idx(new_count));
  for (FrameIndex frame = 0; frame < new_count; ++frame) times.push_back(frame * old_rate_hz / new_rate_hz);
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
  Motion target = resampled_at(skeleton, motion, new_times(old_rate_hz, new_rate_hz, new_count));
  target.set_frame_time_s(1.0 / new_rate_hz);
  return target;
}

double snapped_to_frame(double frame) {
  const double whole = std::round(frame);
  return std::abs(frame - whole) < kSameFrame ? whole : frame;
}

Motion resampled_at(const Skeleton& skeleton, const Motion& motion, std::span<const double> frames) {
  std::vector<FrameBlend> times;
  times.reserve(frames.size());
  for (const double frame : frames) times.push_back(find_frame_blend(motion.frame_count(), snapped_to_frame(frame)));
  Motion target(motion.channel_count(), size_of(frames), motion.frame_time_s());
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
