#include "core/kinematics/pose.h"

#include <cstring>

#include "core/math/axis_turn.h"
#include "core/math/lanes.h"
#include "core/math/sincos.h"
#include "core/motion/sampling.h"

namespace marey {
namespace {

template <class SampleOf>
glm::dvec3 local_translation(const Skeleton& skeleton, JointIndex joint, PositionRule rule, SampleOf sample_of) {
  const bool adds = skeleton.positions_add(joint, rule);
  glm::dvec3 translation = skeleton.offset(joint);
  ChannelIndex index = skeleton.first_channel(joint);
  for (const Channel& channel : skeleton.channels(joint)) {
    if (is_position(channel.kind)) {
      double& component = translation[static_cast<int>(axis_of(channel.kind))];
      component = adds ? component + sample_of(index) : sample_of(index);
    }
    ++index;
  }
  return translation;
}

// Fetches the samples of a frame, which lie far apart in memory, before anything waits for them.
void gather_samples(const Motion& motion, FrameIndex frame, std::vector<double>& samples) {
  for (ChannelIndex channel = 0; channel < motion.channel_count(); ++channel) {
    samples[idx(channel)] = motion.sample(channel, frame);
  }
}

// Half-angle sines and cosines of all channels, several at once. Positions are taken along: they are few.
void compute_half_turns(LocalPose::Scratch& scratch) {
  for (std::size_t i = 0; i < scratch.samples.size(); i += idx(kLaneCount)) {
    Lanes angles_deg;
    std::memcpy(&angles_deg, &scratch.samples[i], sizeof(angles_deg));
    const SinCos<Lanes> half = sincos_deg(0.5 * angles_deg);
    std::memcpy(&scratch.half_sines[i], &half.sine, sizeof(half.sine));
    std::memcpy(&scratch.half_cosines[i], &half.cosine, sizeof(half.cosine));
  }
}

glm::dquat local_rotation(const Skeleton& skeleton, JointIndex joint, const LocalPose::Scratch& scratch) {
  glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
  std::size_t index = idx(skeleton.first_channel(joint));
  for (const Channel& channel : skeleton.channels(joint)) {
    if (is_rotation(channel.kind)) {
      const SinCos<double> half{scratch.half_sines[index], scratch.half_cosines[index]};
      rotation = turned_about(rotation, axis_of(channel.kind), half);
    }
    ++index;
  }
  return rotation;
}

}  // namespace

glm::dvec3 joint_translation(const Skeleton& skeleton, const Motion& motion, JointIndex joint, FrameIndex frame,
                             PositionRule rule) {
  return local_translation(skeleton, joint, rule, [&](ChannelIndex channel) { return motion.sample(channel, frame); });
}

void LocalPose::resize(const Skeleton& skeleton) {
  local_translations.resize(idx(skeleton.joint_count()), glm::dvec3(0.0));
  local_rotations.resize(idx(skeleton.joint_count()), glm::dquat(1.0, 0.0, 0.0, 0.0));
  const std::size_t whole_lanes = idx((skeleton.channel_count() + kLaneCount - 1) / kLaneCount * kLaneCount);
  for (auto* column : {&scratch.samples, &scratch.half_sines, &scratch.half_cosines}) column->resize(whole_lanes);
}

void WorldPose::resize(const Skeleton& skeleton) {
  world_positions.resize(idx(skeleton.node_count()), glm::dvec3(0.0));
  world_rotations.resize(idx(skeleton.joint_count()), glm::dquat(1.0, 0.0, 0.0, 0.0));
}

void compute_local_pose(const Skeleton& skeleton, const Motion& motion, FrameIndex frame, PositionRule rule,
                        LocalPose& local) {
  gather_samples(motion, frame, local.scratch.samples);
  compute_half_turns(local.scratch);
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    local.local_translations[idx(joint)] = local_translation(
        skeleton, joint, rule, [&](ChannelIndex channel) { return local.scratch.samples[idx(channel)]; });
    local.local_rotations[idx(joint)] = local_rotation(skeleton, joint, local.scratch);
  }
}

void compute_local_pose_between(const Skeleton& skeleton, const Motion& motion, double frame, PositionRule rule,
                                LocalPose& local) {
  const FrameBlend at = find_frame_blend(motion.frame_count(), frame);
  if (at.weight == 0.0) return compute_local_pose(skeleton, motion, at.frame, rule, local);
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    local.local_translations[idx(joint)] = local_translation(
        skeleton, joint, rule, [&](ChannelIndex channel) { return sample_at(motion, channel, at); });
    local.local_rotations[idx(joint)] = joint_rotation(skeleton, motion, joint, at);
  }
}

void compute_rest_pose(const Skeleton& skeleton, LocalPose& local) {
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    local.local_translations[idx(joint)] = skeleton.offset(joint);
    local.local_rotations[idx(joint)] = glm::dquat(1.0, 0.0, 0.0, 0.0);
  }
}

void compute_world_pose(const Skeleton& skeleton, const LocalPose& local, WorldPose& world) {
  for (NodeIndex index = 0; index < skeleton.node_count(); ++index) {
    const Node& node = skeleton.node(index);
    const glm::dvec3& translation = node.is_end_site ? node.offset : local.local_translations[idx(node.joint)];
    glm::dvec3 position = translation;
    glm::dquat rotation = node.is_end_site ? glm::dquat(1.0, 0.0, 0.0, 0.0) : local.local_rotations[idx(node.joint)];
    if (node.parent != kNoParent) {
      const glm::dquat& parent = world.world_rotations[idx(skeleton.node(node.parent).joint)];
      position = world.world_positions[idx(node.parent)] + parent * translation;
      rotation = parent * rotation;
    }
    world.world_positions[idx(index)] = position;
    if (!node.is_end_site) world.world_rotations[idx(node.joint)] = rotation;
  }
}

}  // namespace marey
