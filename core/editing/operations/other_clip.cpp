#include "core/editing/operations/other_clip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/counted.h"
#include "core/editing/operations/new_samples.h"
#include "core/motion/resampling.h"

namespace marey {
namespace {

std::optional<ChannelIndex> find_channel(const Skeleton& skeleton, JointIndex joint, ChannelKind kind) {
  for (int i = 0; i < skeleton.channel_count(joint); ++i) {
    const ChannelIndex channel = skeleton.first_channel(joint) + i;
    if (skeleton.channel(channel).kind == kind) return channel;
  }
  return std::nullopt;
}

/// Carries the joints of one clip over to another.
class Adoption {
 public:
  Adoption(const Clip& clip, const Clip& other, const Motion& source, FrameIndex held_frame)
      : clip_(clip), other_(other), source_(source) {
    adopted_.motion = Motion(clip.motion.channel_count(), source.frame_count(), clip.motion.frame_time_s());
    for (ChannelIndex c = 0; c < clip.motion.channel_count(); ++c) {
      const std::span<double> samples = adopted_.motion.channel_samples(c);
      std::fill(samples.begin(), samples.end(), clip.motion.frame_count() > 0 ? clip.motion.sample(c, held_frame) : 0.0);
    }
  }

  OtherMotion adopt() {
    std::map<std::string_view, JointIndex> by_name;
    for (JointIndex joint = 0; joint < other_.skeleton.joint_count(); ++joint) by_name.emplace(other_.skeleton.name(joint), joint);
    for (JointIndex joint = 0; joint < clip_.skeleton.joint_count(); ++joint) {
      const auto found = by_name.find(clip_.skeleton.name(joint));
      if (found == by_name.end()) {
        adopted_.missing.push_back(joint);
      } else {
        adopt_joint(joint, found->second);
      }
    }
    return std::move(adopted_);
  }

 private:
  void adopt_joint(JointIndex joint, JointIndex from) {
    const bool same_order = euler_order_label(clip_.skeleton, joint) == euler_order_label(other_.skeleton, from);
    const auto to_euler = find_euler_channels(clip_.skeleton, joint);
    const auto from_euler = find_euler_channels(other_.skeleton, from);
    const bool by_rotation = !same_order && to_euler && from_euler && to_euler->count == 3;
    if (by_rotation) adopt_rotation(*to_euler, *from_euler);
    for (int i = 0; i < clip_.skeleton.channel_count(joint); ++i) {
      const ChannelIndex channel = clip_.skeleton.first_channel(joint) + i;
      const ChannelKind kind = clip_.skeleton.channel(channel).kind;
      if (kind == ChannelKind::Other || (is_rotation(kind) && by_rotation)) continue;
      const auto source = find_channel(other_.skeleton, from, kind);
      if (!source) continue;
      const std::span<const double> samples = source_.channel_samples(*source);
      std::copy(samples.begin(), samples.end(), adopted_.motion.channel_samples(channel).begin());
      if (is_position(kind)) shift_position(channel, joint, from);
    }
  }

  // Position channels that add to different offsets mean different places.
  void shift_position(ChannelIndex channel, JointIndex joint, JointIndex from) {
    const int axis = static_cast<int>(axis_of(clip_.skeleton.channel(channel).kind));
    const bool adds = clip_.skeleton.positions_add(joint, clip_.settings.position_rule);
    const bool other_adds = other_.skeleton.positions_add(from, other_.settings.position_rule);
    const double shift = (other_adds ? other_.skeleton.offset(from)[axis] : 0.0) - (adds ? clip_.skeleton.offset(joint)[axis] : 0.0);
    if (shift == 0.0) return;
    for (double& sample : adopted_.motion.channel_samples(channel)) sample += shift;
  }

  void adopt_rotation(const EulerChannels& to, const EulerChannels& from) {
    glm::dvec3 previous(0.0);
    for (FrameIndex frame = 0; frame < source_.frame_count(); ++frame) {
      const glm::dquat rotation = rotation_from_euler(from.order, angles_deg_of(source_, from, frame));
      if (std::isfinite(rotation.w)) previous = euler_near(to.order, glm::mat3_cast(rotation), previous);
      for (int i = 0; i < 3; ++i) adopted_.motion.channel_samples(to.channels[i])[idx(frame)] = previous[i];
    }
  }

  const Clip& clip_;
  const Clip& other_;
  const Motion& source_;
  OtherMotion adopted_;
};

bool is_same_rate(double a_s, double b_s) {
  const double a = display_frame_rate_hz(a_s);
  const double b = display_frame_rate_hz(b_s);
  return std::abs(a - b) <= 1e-6 * a;
}

void mix_channel(const std::vector<double>& weights, std::span<const double> from, std::span<const double> to,
                 std::span<double> mixed) {
  for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i] = from[i] + weights[i] * (to[i] - from[i]);
}

}  // namespace

Result<OtherMotion> adopt_motion(const Clip& clip, const Clip& other, FrameIndex held_frame) {
  const bool same_rate = is_same_rate(clip.motion.frame_time_s(), other.motion.frame_time_s());
  Result<Motion> source = other.motion;
  if (!same_rate) source = resampled(other.skeleton, other.motion, display_frame_rate_hz(clip.motion.frame_time_s()));
  if (!source) return source.error();
  OtherMotion adopted = Adoption(clip, other, *source, held_frame).adopt();
  const int missing = size_of(adopted.missing);
  if (missing == clip.skeleton.joint_count()) {
    return Error{DiagnosticCode::InvalidArgument, {}, "The other clip has no joint of the same name.", {}, {}};
  }
  if (!same_rate) {
    adopted.notes.push_back(fmt::format("The other clip was resampled to {:.6g} frames a second.",
                                        display_frame_rate_hz(clip.motion.frame_time_s())));
  }
  if (missing > 0) {
    adopted.notes.push_back(fmt::format("The other clip does not have {}: {}{}", counted(missing, "joint"),
                                        clip.skeleton.name(adopted.missing[0]), missing > 1 ? " and others." : "."));
  }
  return adopted;
}

Motion mixed_motion(const Skeleton& skeleton, const Motion& from, const Motion& to, const std::vector<double>& weights) {
  Motion mixed(from.channel_count(), from.frame_count(), from.frame_time_s());
  for (ChannelIndex c = 0; c < mixed.channel_count(); ++c) {
    mix_channel(weights, from.channel_samples(c), to.channel_samples(c), mixed.channel_samples(c));
  }
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const auto euler = find_euler_channels(skeleton, joint);
    if (!euler) continue;
    for (FrameIndex frame = 0; frame < mixed.frame_count(); ++frame) {
      const glm::dvec3 angles = mixed_angles(*euler, angles_deg_of(from, *euler, frame), angles_deg_of(to, *euler, frame),
                                             weights[idx(frame)]);
      for (int i = 0; i < euler->count; ++i) mixed.channel_samples(euler->channels[i])[idx(frame)] = angles[i];
    }
  }
  return mixed;
}

}  // namespace marey
