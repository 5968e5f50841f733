#include "core/interchange/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/counted.h"
#include "core/lint/wording.h"
#include "core/skeleton/skeleton_builder.h"

namespace marey {
namespace {

constexpr std::array<ChannelKind, 3> kPositions = {ChannelKind::Xposition, ChannelKind::Yposition,
                                                   ChannelKind::Zposition};
constexpr std::array<ChannelKind, 3> kRotations = {ChannelKind::Xrotation, ChannelKind::Yrotation,
                                                   ChannelKind::Zrotation};

RigJoint::Curve tidy_curve(std::span<const double> samples) {
  constexpr double kSmallest = 1e-30;
  RigJoint::Curve curve(samples.begin(), samples.end());
  for (double& sample : curve) {
    if (std::abs(sample) < kSmallest) sample = 0.0;
  }
  return curve;
}

/// A second channel of one axis replaces or adds like the first.
void take_position(const Clip& clip, ChannelIndex channel, RigJoint& joint) {
  const int axis = static_cast<int>(axis_of(clip.skeleton.channel(channel).kind));
  RigJoint::Curve& curve = joint.positions[idx(axis)];
  RigJoint::Curve samples = tidy_curve(clip.motion.channel_samples(channel));
  if (clip.skeleton.positions_add(clip.skeleton.channel(channel).joint, clip.settings.position_rule)) {
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] += curve.empty() ? joint.offset[axis] : curve[i];
  }
  curve = std::move(samples);
}

/// Takes the channels of a joint over; true if a position stands behind a rotation.
bool take_channels(const Clip& clip, JointIndex index, RigJoint& joint, int& dropped) {
  bool is_reordered = false;
  for (int i = 0; i < clip.skeleton.channel_count(index); ++i) {
    const ChannelIndex channel = clip.skeleton.first_channel(index) + i;
    const ChannelKind kind = clip.skeleton.channel(channel).kind;
    if (is_position(kind)) {
      is_reordered = is_reordered || !joint.axes.empty();
      take_position(clip, channel, joint);
    } else if (is_rotation(kind)) {
      joint.axes.push_back(axis_of(kind));
      joint.angles_deg.push_back(tidy_curve(clip.motion.channel_samples(channel)));
    } else {
      ++dropped;
    }
  }
  return is_reordered;
}

void append_channels(const Rig& rig, PositionRule rule, std::vector<double>& samples) {
  for (const RigJoint& joint : rig.joints) {
    for (int axis = 0; axis < 3; ++axis) {
      const double less = rule == PositionRule::Add ? joint.offset[axis] : 0.0;
      for (const double sample : joint.positions[idx(axis)]) samples.push_back(sample - less);
    }
    for (const RigJoint::Curve& curve : joint.angles_deg) samples.insert(samples.end(), curve.begin(), curve.end());
  }
}

void add_joint(const RigJoint& joint, SkeletonBuilder& builder, int& node_count, std::vector<NodeIndex>& nodes) {
  builder.open_joint(joint.name, joint.offset);
  if (joint.origin != kNoParent) nodes[idx(joint.origin)] = node_count;
  ++node_count;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!joint.positions[axis].empty()) builder.add_channel(kPositions[axis]);
  }
  for (const Axis axis : joint.axes) builder.add_channel(kRotations[static_cast<std::size_t>(axis)]);
  for (const RigEnd& end : joint.end_sites) {
    const NodeIndex node = builder.add_end_site(end.offset, end.name);
    if (end.origin != kNoParent) nodes[idx(end.origin)] = node;
    ++node_count;
  }
}

}  // namespace

bool RigJoint::has_positions() const {
  return std::any_of(positions.begin(), positions.end(), [](const Curve& curve) { return !curve.empty(); });
}

glm::dvec3 RigJoint::place(FrameIndex frame) const {
  glm::dvec3 result = offset;
  for (int axis = 0; axis < 3; ++axis) {
    if (!positions[idx(axis)].empty()) result[axis] = positions[idx(axis)][idx(frame)];
  }
  return result;
}

std::vector<bool> Rig::with_children() const {
  std::vector<bool> result(joints.size());
  for (const RigJoint& joint : joints) {
    if (joint.parent != kNoParent) result[idx(joint.parent)] = true;
  }
  return result;
}

std::string listed_joints(const Rig& rig, const std::vector<JointIndex>& joints) {
  std::vector<std::string> names;
  for (const JointIndex joint : joints) names.push_back(lint::quoted(rig.joints[idx(joint)].name));
  return lint::listed(names);
}

Rig make_rig(const Clip& clip, ExportChanges& changes) {
  const Skeleton& skeleton = clip.skeleton;
  Rig rig;
  rig.frame_count = clip.motion.frame_count();
  rig.frame_time_s = clip.motion.frame_time_s();
  int dropped = 0;
  std::vector<JointIndex> reordered;
  for (JointIndex index = 0; index < skeleton.joint_count(); ++index) {
    RigJoint joint;
    joint.name = skeleton.name(index);
    joint.parent = skeleton.parent(index);
    joint.offset = skeleton.offset(index);
    joint.origin = skeleton.node_of(index);
    if (take_channels(clip, index, joint, dropped)) reordered.push_back(index);
    rig.joints.push_back(std::move(joint));
  }
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const Node& end = skeleton.node(node);
    if (end.is_end_site) rig.joints[idx(end.joint)].end_sites.push_back({end.offset, end.name, node});
  }
  if (dropped > 0) {
    changes.push_back({ExportChangeKind::ChannelsDropped, true, dropped,
                       fmt::format("{} of scale or unknown kind, which move nothing here, {} left out.",
                                   counted(dropped, "channel"), dropped == 1 ? "is" : "are")});
  }
  if (!reordered.empty()) {
    changes.push_back({ExportChangeKind::ChannelsReordered, false, size_of(reordered),
                       fmt::format("Positions stand before the rotations at {}: {}.",
                                   counted(size_of(reordered), "joint"), listed_joints(rig, reordered))});
  }
  return rig;
}

Result<ExportedClip> assembled(const Rig& rig, PositionRule rule, int original_node_count) {
  ExportedClip clip;
  clip.nodes.assign(idx(original_node_count), kNoParent);
  SkeletonBuilder builder;
  int node_count = 0;
  std::size_t channel_count = 0;
  for (const RigJoint& joint : rig.joints) {
    while (builder.current_joint() != joint.parent) builder.close_joint();
    add_joint(joint, builder, node_count, clip.nodes);
    channel_count += joint.axes.size();
    for (const RigJoint::Curve& curve : joint.positions) channel_count += curve.empty() ? 0U : 1U;
  }
  while (builder.open_depth() > 0) builder.close_joint();
  Result<Skeleton> skeleton = builder.build();
  if (!skeleton) return skeleton.error();
  std::vector<double> samples;
  samples.reserve(channel_count * idx(rig.frame_count));
  append_channels(rig, rule, samples);
  clip.skeleton = std::move(*skeleton);
  clip.motion = Motion(static_cast<int>(channel_count), rig.frame_count, rig.frame_time_s, std::move(samples));
  clip.position_rule = rule;
  clip.added_frames = rig.starts_with_added_pose ? 1 : 0;
  return clip;
}

}  // namespace marey
