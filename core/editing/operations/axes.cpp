#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "core/base/counted.h"
#include "core/editing/body_carrying.h"
#include "core/editing/figure_draft.h"
#include "core/editing/operations/families.h"
#include "core/editing/operations/figure_edit.h"
#include "core/editing/operations/new_samples.h"
#include "core/motion/sampling.h"

namespace marey {
namespace {

using Outcome = Result<OperationOutcome>;

constexpr double kNearGimbalLockDeg = 5.0;

/// The angles of one joint while its order changes.
struct Reordered {
  std::array<std::vector<double>, 3> angles;  ///< by the place of their axis in the new order
  int near_gimbal_lock = 0;                   ///< frames
};

glm::dvec3 by_axis(EulerOrder order, const glm::dvec3& angles) {
  glm::dvec3 sorted(0.0);
  sorted[static_cast<int>(order.first)] += angles.x;
  sorted[static_cast<int>(order.second)] += angles.y;
  sorted[static_cast<int>(order.third)] += angles.z;
  return sorted;
}

glm::dvec3 in_order(EulerOrder order, const glm::dvec3& sorted) {
  return {sorted[static_cast<int>(order.first)], sorted[static_cast<int>(order.second)], sorted[static_cast<int>(order.third)]};
}

// Each frame is near to where the old angles say it goes, axis by axis, so counts of turns stay where they can.
Reordered reorder(const Motion& motion, const EulerChannels& from, EulerOrder to) {
  Reordered result;
  glm::dvec3 last_old(0.0);
  glm::dvec3 last_new(0.0);
  for (FrameIndex frame = 0; frame < motion.frame_count(); ++frame) {
    const glm::dvec3 old = angles_deg_of(motion, from, frame);
    const glm::dmat3 rotation = glm::mat3_cast(rotation_from_euler(from.order, old));
    glm::dvec3 angles = old;  // what is not finite stays so
    if (std::isfinite(rotation[0][0])) {
      const glm::dvec3 sorted = by_axis(from.order, old);
      angles = euler_near(to, rotation, last_new + in_order(to, sorted - last_old));
      last_old = sorted;
      last_new = angles;
      const double beyond = std::abs(std::remainder(angles.y, 180.0));
      result.near_gimbal_lock += beyond > 90.0 - kNearGimbalLockDeg ? 1 : 0;
    }
    for (int i = 0; i < 3; ++i) result.angles[idx(i)].push_back(angles[i]);
  }
  return result;
}

void set_order(NodeDraft& node, EulerOrder order, Reordered reordered) {
  const Axis axes[] = {order.first, order.second, order.third};
  std::size_t next = 0;
  for (ChannelDraft& channel : node.channels) {
    if (!is_rotation(channel.kind)) continue;
    channel.kind = static_cast<ChannelKind>(static_cast<int>(ChannelKind::Xrotation) + static_cast<int>(axes[next]));
    channel.samples = std::move(reordered.angles[next]);
    ++next;
  }
}

EulerOrder order_named(std::string_view name) {
  const auto axis = [&](std::size_t i) { return static_cast<Axis>(name[i] - 'x'); };
  return {axis(0), axis(1), axis(2)};
}

Outcome make_change_order(const OperationCall& call) {
  const Skeleton& skeleton = call.clip.skeleton;
  const EulerOrder order = order_named(call.choice("order"));
  FigureDraft draft = take_apart(call.clip);
  std::vector<std::string> notes;
  int changed = 0;
  for (const JointIndex joint : call.target.joints) {
    const auto euler = find_euler_channels(skeleton, joint);
    if (!euler || euler->count < 3 || euler->order == order || euler->order.first == euler->order.third) continue;
    Reordered reordered = reorder(call.clip.motion, *euler, order);
    if (reordered.near_gimbal_lock > 0) {
      notes.push_back(fmt::format("'{}' comes near gimbal lock in {}.", skeleton.name(joint),
                                  counted(reordered.near_gimbal_lock, "frame")));
    }
    set_order(draft.nodes[idx(skeleton.node_of(joint))], order, std::move(reordered));
    ++changed;
  }
  if (changed == 0) return OperationOutcome{};
  return make_figure_edit(call, std::move(draft), std::move(notes));
}

// 0 keeps its sign, so that no "-0" comes into the file.
double signed_value(double sign, double value) { return sign < 0.0 && value != 0.0 ? -value : value; }

/// A quarter turn, as it takes the axes to each other.
struct QuarterTurn {
  std::array<int, 3> to{};        ///< where each axis comes
  std::array<double, 3> sign{};  ///< 1 or -1

  [[nodiscard]] glm::dvec3 apply(const glm::dvec3& v) const {
    glm::dvec3 turned(0.0);
    for (int axis = 0; axis < 3; ++axis) turned[to[idx(axis)]] = signed_value(sign[idx(axis)], v[axis]);
    return turned;
  }
};

// The turn about the third axis that brings `from` to `to`.
QuarterTurn quarter_turn(Axis from, Axis to) {
  const int a = static_cast<int>(from);
  const int b = static_cast<int>(to);
  QuarterTurn turn{{0, 1, 2}, {1.0, 1.0, 1.0}};
  turn.to[idx(a)] = b;
  turn.to[idx(b)] = a;
  turn.sign[idx(b)] = -1.0;
  return turn;
}

void turn_channel(const QuarterTurn& turn, ChannelDraft& channel) {
  if (channel.kind == ChannelKind::Other) return;
  const int axis = static_cast<int>(axis_of(channel.kind));
  const int group = static_cast<int>(channel.kind) - axis;
  const double sign = is_scale(channel.kind) ? 1.0 : turn.sign[idx(axis)];
  channel.kind = static_cast<ChannelKind>(group + turn.to[idx(axis)]);
  for (double& sample : channel.samples) sample = signed_value(sign, sample);
}

Outcome make_up_axis(const OperationCall& call) {
  const Axis from = call.clip.settings.up_axis;
  const auto to = static_cast<Axis>(call.whole("to"));
  if (from == to) return OperationOutcome{};
  const QuarterTurn turn = quarter_turn(from, to);
  FigureDraft draft = take_apart(call.clip);
  for (NodeDraft& node : draft.nodes) {
    node.offset = turn.apply(node.offset);
    for (ChannelDraft& channel : node.channels) turn_channel(turn, channel);
  }
  Outcome outcome = make_figure_edit(call, std::move(draft), {});
  if (!outcome) return outcome;
  ClipSettings settings = call.clip.settings;
  settings.up_axis = to;
  outcome->edit.settings = settings;
  glm::dmat3 rotation(0.0);
  for (int axis = 0; axis < 3; ++axis) rotation[axis][turn.to[idx(axis)]] = turn.sign[idx(axis)];
  BodyChoice body = call.clip.body;
  turn_own_segments(body, std::vector<glm::dmat3>(idx(call.clip.skeleton.joint_count()), rotation));
  if (body.gravity_mps2) body.gravity_mps2 = turn.apply(*body.gravity_mps2);
  if (!(body == call.clip.body)) outcome->edit.body = std::move(body);
  return outcome;
}

/// Rotations of all joints in the world, in the pose that is to be the rest pose.
std::vector<glm::dquat> world_rotations(const Clip& clip, FrameIndex frame) {
  std::vector<glm::dquat> rotations;
  for (JointIndex joint = 0; joint < clip.skeleton.joint_count(); ++joint) {
    const JointIndex parent = clip.skeleton.parent(joint);
    const glm::dquat local = joint_rotation(clip.skeleton, clip.motion, joint, frame);
    rotations.push_back(parent == kNoParent ? local : glm::normalize(rotations[idx(parent)] * local));
  }
  return rotations;
}

bool is_identity(const glm::dquat& q) { return std::abs(q.x) + std::abs(q.y) + std::abs(q.z) < 1e-12; }

// W_parent R W^-1 for each frame, as the angles nearest to those of the frame before.
void rebase_rotations(const OperationCall& call, const EulerChannels& euler, const glm::dquat& above, const glm::dquat& own,
                      std::vector<NewSamples>& samples) {
  std::vector<NewSamples> angles = copied_angles(call, euler);
  glm::dvec3 previous(0.0);
  for (int i = 0; i < call.target.frames.count; ++i) {
    const glm::dquat local = rotation_from_euler(euler.order, angles_deg_of(call.clip.motion, euler, i));
    const glm::dmat3 rotation = glm::mat3_cast(glm::normalize(above * local * glm::conjugate(own)));
    if (!std::isfinite(rotation[0][0])) continue;
    previous = euler_near(euler.order, rotation, previous);
    set_angles(angles, idx(i), previous);
  }
  append(samples, std::move(angles));
}

Error cannot_rebase(const Skeleton& skeleton, JointIndex joint) {
  return {DiagnosticCode::InvalidArgument, {},
          fmt::format("'{}' has not the three rotation channels that another rest pose takes, or positions of its own.",
                      skeleton.name(joint)), {}, {}};
}

Outcome make_rest_pose(const OperationCall& call) {
  const Skeleton& skeleton = call.clip.skeleton;
  const int frame_count = call.clip.motion.frame_count();
  if (frame_count == 0) return OperationOutcome{};
  const OperationTarget whole = whole_clip(call.clip);
  const OperationCall all{call.clip, whole, call.operation, call.values};
  const std::vector<glm::dquat> rest = world_rotations(call.clip, std::min(call.whole("frame"), frame_count - 1));
  OperationOutcome outcome;
  std::vector<NewSamples> samples;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const glm::dquat own = rest[idx(joint)];
    const JointIndex parent = skeleton.parent(joint);
    const glm::dquat above = parent == kNoParent ? glm::dquat(1.0, 0.0, 0.0, 0.0) : rest[idx(parent)];
    if (is_identity(above) && is_identity(own)) continue;
    const auto euler = find_euler_channels(skeleton, joint);
    if (!euler || euler->count < 3 || has_own_positions(skeleton, joint)) return cannot_rebase(skeleton, joint);
    rebase_rotations(all, *euler, above, own, samples);
  }
  std::sort(samples.begin(), samples.end(), [](const NewSamples& a, const NewSamples& b) { return a.channel < b.channel; });
  outcome.edit = blended_edit(all, std::move(samples));
  outcome.edit.name = call.operation.label;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const Node& n = skeleton.node(node);
    const JointIndex above = n.is_end_site ? n.joint : skeleton.parent(n.joint);
    if (above != kNoParent) outcome.edit.offsets.push_back({node, rest[idx(above)] * n.offset});
  }
  std::vector<glm::dmat3> rotations;
  for (const glm::dquat& rotation : rest) rotations.push_back(glm::mat3_cast(rotation));
  BodyChoice body = call.clip.body;
  turn_own_segments(body, rotations);
  if (!(body == call.clip.body)) outcome.edit.body = std::move(body);
  return outcome;
}

constexpr std::string_view kOrders[] = {"zxy", "zyx", "xyz", "xzy", "yxz", "yzx"};
constexpr OperationParameter kOrder[] = {{.name = "order", .label = "Order", .help = "The rotation channels from left to right.",
                                          .kind = ParameterKind::Choice, .most = 5.0, .choices = kOrders}};
constexpr OperationParameter kUpAxis[] = {{.name = "to", .label = "Up axis", .help = "The axis that is to point up.",
                                           .kind = ParameterKind::Axis, .initial = 1.0, .most = 2.0}};
constexpr OperationParameter kRestPose[] = {
    {.name = "frame", .label = "Frame", .help = "Its pose is the rest pose afterwards.", .kind = ParameterKind::Frame,
     .initial = 0.0, .least = 0.0, .most = 1e9}};

constexpr Operation kAxes[] = {
    {.id = "change-order", .label = "Change rotation order", .group = "Figure",
     .help = "Describes the same rotations by channels in another order.", .reach = OperationReach::Figure,
     .parameters = kOrder, .make = make_change_order},
    {.id = "up-axis", .label = "Turn the up axis", .group = "Figure",
     .help = "Turns figure and movement by a quarter, so that another axis points up.", .reach = OperationReach::Clip,
     .parameters = kUpAxis, .make = make_up_axis},
    {.id = "rest-pose", .label = "Set rest pose", .group = "Figure",
     .help = "Makes the pose of a frame the rest pose; the movement stays.", .reach = OperationReach::Clip,
     .parameters = kRestPose, .make = make_rest_pose}};

}  // namespace

std::span<const Operation> axis_operations() { return kAxes; }

}  // namespace marey
