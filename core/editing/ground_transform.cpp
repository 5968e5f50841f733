#include "core/editing/ground_transform.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "core/math/angle.h"
#include "core/math/sincos.h"
#include "core/motion/euler_channels.h"
#include "core/motion/sampling.h"

namespace marey {
namespace {

/// The channels that place a root: its last position channel per axis, as kinematics takes it.
struct PositionChannels {
  std::array<std::optional<ChannelIndex>, 3> channels{};
  glm::dvec3 added{0.0};  ///< to the channels, by the position rule
};

PositionChannels find_position_channels(const Skeleton& skeleton, PositionRule rule, JointIndex root) {
  PositionChannels found;
  for (int i = 0; i < skeleton.channel_count(root); ++i) {
    const ChannelIndex channel = skeleton.first_channel(root) + i;
    const ChannelKind kind = skeleton.channel(channel).kind;
    if (is_position(kind)) found.channels[static_cast<std::size_t>(axis_of(kind))] = channel;
  }
  if (skeleton.positions_add(root, rule)) found.added = skeleton.offset(root);
  return found;
}

Error refusal(std::string message) { return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; }

bool moves_axis(const GroundTransform& transform, int axis) {
  const bool turns = transform.angle_deg != 0.0 && axis != static_cast<int>(transform.up);
  return turns || transform.shift[axis] != 0.0;
}

Status move_positions(const Skeleton& skeleton, PositionRule rule, const GroundTransform& transform, JointIndex root,
                      Motion& motion) {
  const PositionChannels found = find_position_channels(skeleton, rule, root);
  const bool stands = !found.channels[0] && !found.channels[1] && !found.channels[2];
  if (stands && transform.shift == glm::dvec3(0.0)) return {};
  for (int axis = 0; axis < 3; ++axis) {
    if (moves_axis(transform, axis) && !found.channels[static_cast<std::size_t>(axis)]) {
      return refusal(fmt::format("'{}' has no {}position channel to move it by.", skeleton.name(root), "XYZ"[axis]));
    }
  }
  for (FrameIndex frame = 0; frame < motion.frame_count(); ++frame) {
    const glm::dvec3 moved = transform.apply(root_position(skeleton, rule, motion, root, frame));
    for (int axis = 0; axis < 3; ++axis) {
      if (!moves_axis(transform, axis)) continue;
      double& sample = motion.channel_samples(*found.channels[static_cast<std::size_t>(axis)])[idx(frame)];
      if (std::isfinite(sample)) sample = moved[axis] - found.added[axis];
    }
  }
  return {};
}

std::optional<ChannelIndex> first_rotation_channel(const Skeleton& skeleton, JointIndex root) {
  for (int i = 0; i < skeleton.channel_count(root); ++i) {
    const ChannelIndex channel = skeleton.first_channel(root) + i;
    if (is_rotation(skeleton.channel(channel).kind)) return channel;
  }
  return std::nullopt;
}

void turn_by_euler(const EulerChannels& euler, const GroundTransform& transform, Motion& motion) {
  const glm::dquat turn = axis_rotation(transform.up, transform.angle_deg);
  glm::dvec3 last_own(0.0);
  glm::dvec3 last_turned(0.0);
  bool has_last = false;
  for (FrameIndex frame = 0; frame < motion.frame_count(); ++frame) {
    const glm::dvec3 own = angles_deg_of(motion, euler, frame);
    const glm::dmat3 rotation = glm::mat3_cast(turn * rotation_from_euler(euler.order, own));
    if (!std::isfinite(rotation[0][0])) continue;
    last_turned = euler_near(euler.order, rotation, has_last ? last_turned + (own - last_own) : own);
    last_own = own;
    has_last = true;
    for (int i = 0; i < 3; ++i) motion.channel_samples(euler.channels[i])[idx(frame)] = last_turned[i];
  }
}

Status turn_root(const Skeleton& skeleton, const GroundTransform& transform, JointIndex root, Motion& motion) {
  if (transform.angle_deg == 0.0) return {};
  const std::optional<ChannelIndex> first = first_rotation_channel(skeleton, root);
  if (first && axis_of(skeleton.channel(*first).kind) == transform.up) {
    for (double& sample : motion.channel_samples(*first)) sample += transform.angle_deg;
    return {};
  }
  const std::optional<EulerChannels> euler = find_euler_channels(skeleton, root);
  if (!euler || euler->count < 3) {
    return refusal(fmt::format("'{}' has not the rotation channels to turn it by.", skeleton.name(root)));
  }
  turn_by_euler(*euler, transform, motion);
  return {};
}

}  // namespace

std::pair<int, int> ground_axes(Axis up) {
  const int axis = static_cast<int>(up);
  return {(axis + 1) % 3, (axis + 2) % 3};
}

glm::dvec3 GroundTransform::apply(const glm::dvec3& position) const {
  const auto [a, b] = ground_axes(up);
  glm::dvec3 moved = position;
  if (angle_deg != 0.0) {
    const SinCos<double> turn = sincos_deg(angle_deg);
    const double from_a = position[a] - pivot[a];
    const double from_b = position[b] - pivot[b];
    moved[a] = pivot[a] + turn.cosine * from_a - turn.sine * from_b;
    moved[b] = pivot[b] + turn.sine * from_a + turn.cosine * from_b;
  }
  return moved + shift;
}

Status move_roots(const Skeleton& skeleton, PositionRule rule, const GroundTransform& transform, Motion& motion) {
  for (JointIndex root = 0; root < skeleton.joint_count(); ++root) {
    if (skeleton.parent(root) != kNoParent) continue;
    if (Status status = move_positions(skeleton, rule, transform, root, motion); !status) return status;
    if (Status status = turn_root(skeleton, transform, root, motion); !status) return status;
  }
  return {};
}

glm::dvec3 root_position(const Skeleton& skeleton, PositionRule rule, const Motion& motion, JointIndex root,
                         FrameIndex frame) {
  const PositionChannels found = find_position_channels(skeleton, rule, root);
  glm::dvec3 position = skeleton.offset(root);
  for (int axis = 0; axis < 3; ++axis) {
    const auto& channel = found.channels[static_cast<std::size_t>(axis)];
    if (channel) position[axis] = found.added[axis] + motion.sample(*channel, frame);
  }
  return position;
}

double twist_deg(const Skeleton& skeleton, const Motion& motion, JointIndex root, FrameIndex frame, Axis axis) {
  const glm::dquat rotation = joint_rotation(skeleton, motion, root, frame);
  const double along = rotation[static_cast<int>(axis)];
  if (!std::isfinite(rotation.w) || (along == 0.0 && rotation.w == 0.0)) return 0.0;
  return nearest_turn(to_degrees(2.0 * std::atan2(along, rotation.w)), 0.0);
}

GroundTransform find_alignment(Axis up, std::span<const double> points, std::span<const double> to) {
  const auto [a, b] = ground_axes(up);
  double n = 0.0, pa = 0.0, pb = 0.0, ta = 0.0, tb = 0.0, cross = 0.0, dot = 0.0;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    const double p[2] = {points[i + idx(a)], points[i + idx(b)]};
    const double t[2] = {to[i + idx(a)], to[i + idx(b)]};
    if (!std::isfinite(p[0] + p[1] + t[0] + t[1])) continue;
    n += 1.0;
    pa += p[0];
    pb += p[1];
    ta += t[0];
    tb += t[1];
    cross += p[0] * t[1] - p[1] * t[0];
    dot += p[0] * t[0] + p[1] * t[1];
  }
  GroundTransform transform{.up = up};
  if (n == 0.0) return transform;
  const double about_cross = cross - (pa * tb - pb * ta) / n;
  const double about_dot = dot - (pa * ta + pb * tb) / n;
  if (about_cross != 0.0 || about_dot != 0.0) transform.angle_deg = to_degrees(std::atan2(about_cross, about_dot));
  transform.pivot[a] = pa / n;
  transform.pivot[b] = pb / n;
  transform.shift[a] = (ta - pa) / n;
  transform.shift[b] = (tb - pb) / n;
  return transform;
}

}  // namespace marey
