#include "core/kinematics/frame_block.h"

#include <algorithm>
#include <numeric>

namespace marey {

FrameBlock::FrameBlock(const Skeleton& skeleton, const Motion& motion, PositionRule rule,
                       std::span<const NodeIndex> nodes)
    : frame_count_(motion.frame_count()) {
  steps_.reserve(nodes.size());
  drives_.reserve(idx(skeleton.channel_count()));
  for (NodeIndex node : nodes) add_step(skeleton, motion, rule, node);
  int deepest = 0;
  for (const Step& step : steps_) deepest = std::max(deepest, step.level);
  ancestors_.resize(idx(deepest) + 1);
  ancestors_[0].rotation.w.fill(1.0);
}

FrameBlock::FrameBlock(const Skeleton& skeleton, const Motion& motion, PositionRule rule)
    : FrameBlock(skeleton, motion, rule, [&] {
        std::vector<NodeIndex> all(idx(skeleton.node_count()));
        std::iota(all.begin(), all.end(), 0);
        return all;
      }()) {}

void FrameBlock::add_step(const Skeleton& skeleton, const Motion& motion, PositionRule rule, NodeIndex index) {
  const Node& node = skeleton.node(index);
  const bool adds = skeleton.positions_add(node.joint, rule);
  Step step{index, skeleton.depth(node.joint) + 1, !node.is_end_site, adds, node.offset, {}, {}};
  if (node.is_end_site) {
    ++step.level;
  } else {
    step.moves = add_drives(skeleton, motion, node.joint, is_position);
    step.turns = add_drives(skeleton, motion, node.joint, is_rotation);
  }
  steps_.push_back(step);
}

template <class Wanted>
FrameBlock::Drives FrameBlock::add_drives(const Skeleton& skeleton, const Motion& motion, JointIndex joint,
                                          Wanted wanted) {
  const std::size_t first = drives_.size();
  ChannelIndex index = skeleton.first_channel(joint);
  for (const Channel& channel : skeleton.channels(joint)) {
    if (wanted(channel.kind)) {
      drives_.push_back({axis_of(channel.kind), motion.channel_samples(index).data()});
    }
    ++index;
  }
  return {first, drives_.size() - first};
}

/// The samples of a channel lie far from those of the next one, where processors do not look ahead by themselves: the next
/// block's are asked for while this one is computed.
void FrameBlock::fetch_ahead(const double* samples, FrameIndex first) const {
  constexpr int kSamplesPerCacheLine = 8;
  const FrameIndex end = std::min(first + kMaxFrames, frame_count_);
  for (FrameIndex i = first; i < end; i += kSamplesPerCacheLine) __builtin_prefetch(samples + i);
}

void FrameBlock::place(const Step& step, FrameRange frames) {
  Column* const local[] = {&local_.x, &local_.y, &local_.z};
  for (int axis = 0; axis < 3; ++axis) local[axis]->fill(step.offset[axis]);
  for (const Drive& move : drives(step.moves)) {
    Column& coordinate = *local[static_cast<int>(move.axis)];
    const double* samples = move.samples + frames.first;
    if (step.positions_add) {
      for (int i = 0; i < frames.count; ++i) coordinate[idx(i)] += samples[i];
    } else {
      std::copy_n(samples, frames.count, coordinate.begin());
    }
  }
  const JointColumns& parent = ancestors_[idx(step.level) - 1];
  kernels_.place(parent.rotation, parent.positions, local_, frames.count, ancestors_[idx(step.level)].positions);
}

void FrameBlock::turn(const Step& step, FrameRange frames) {
  const QuaternionColumns* from = &ancestors_[idx(step.level) - 1].rotation;
  QuaternionColumns& own = ancestors_[idx(step.level)].rotation;
  if (step.turns.count == 0) own = *from;
  for (const Drive& turn : drives(step.turns)) {
    fetch_ahead(turn.samples, frames.end());
    kernels_.find_half_turns(turn.samples + frames.first, frames.count, half_sines_, half_cosines_);
    kernels_.turn(turn.axis, half_sines_, half_cosines_, *from, frames.count, own);
    from = &own;
  }
}

}  // namespace marey
