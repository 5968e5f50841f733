#include "core/kinematics/frame_block.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "core/math/axis_turn.h"
#include "core/math/lanes.h"
#include "core/math/sincos.h"

namespace marey {
namespace {

using Column = FrameBlock::Column;

struct LaneQuat {
  Lanes w, x, y, z;
};

struct LaneVector {
  Lanes x, y, z;
};

Lanes load(const Column& column, int i) {
  Lanes lanes;
  std::memcpy(&lanes, &column[idx(i)], sizeof(lanes));
  return lanes;
}

void store(Column& column, int i, const Lanes& lanes) { std::memcpy(&column[idx(i)], &lanes, sizeof(lanes)); }

// The samples of a curve may end within the lanes.
Lanes load_samples(const double* samples, int count) {
  Lanes lanes{};
  if (count >= kLaneCount) {
    std::memcpy(&lanes, samples, sizeof(lanes));
  } else {
    std::memcpy(&lanes, samples, idx(count) * sizeof(double));
  }
  return lanes;
}

// q * v * conjugate(q) for unit q.
LaneVector rotated(const LaneQuat& q, const LaneVector& v) {
  const Lanes x = 2.0 * (q.y * v.z - q.z * v.y);
  const Lanes y = 2.0 * (q.z * v.x - q.x * v.z);
  const Lanes z = 2.0 * (q.x * v.y - q.y * v.x);
  return {v.x + q.w * x + (q.y * z - q.z * y), v.y + q.w * y + (q.z * x - q.x * z),
          v.z + q.w * z + (q.x * y - q.y * x)};
}

}  // namespace

FrameBlock::FrameBlock(const Skeleton& skeleton, const Motion& motion, PositionRule rule,
                       std::span<const NodeIndex> nodes) {
  steps_.reserve(nodes.size());
  drives_.reserve(idx(skeleton.channel_count()));
  for (NodeIndex node : nodes) add_step(skeleton, motion, rule, node);
  int deepest = 0;
  for (const Step& step : steps_) deepest = std::max(deepest, step.level);
  ancestors_.resize(idx(deepest) + 1);
  ancestors_[0].w.fill(1.0);
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

void FrameBlock::place(const Step& step, FrameRange frames) {
  const JointColumns& parent = ancestors_[idx(step.level) - 1];
  Positions& own = ancestors_[idx(step.level)].positions;
  const Lanes zero{};
  for (int i = 0; i < frames.count; i += kLaneCount) {
    Lanes local[3] = {zero + step.offset.x, zero + step.offset.y, zero + step.offset.z};
    for (const Drive& move : drives(step.moves)) {
      const Lanes sample = load_samples(move.samples + frames.first + i, frames.count - i);
      Lanes& coordinate = local[static_cast<int>(move.axis)];
      coordinate = step.positions_add ? coordinate + sample : sample;
    }
    const LaneQuat q = {load(parent.w, i), load(parent.x, i), load(parent.y, i), load(parent.z, i)};
    const LaneVector moved = rotated(q, {local[0], local[1], local[2]});
    store(own.x, i, load(parent.positions.x, i) + moved.x);
    store(own.y, i, load(parent.positions.y, i) + moved.y);
    store(own.z, i, load(parent.positions.z, i) + moved.z);
  }
}

void FrameBlock::turn(const Step& step, FrameRange frames) {
  const JointColumns& parent = ancestors_[idx(step.level) - 1];
  JointColumns& own = ancestors_[idx(step.level)];
  for (int i = 0; i < frames.count; i += kLaneCount) {
    LaneQuat q = {load(parent.w, i), load(parent.x, i), load(parent.y, i), load(parent.z, i)};
    for (const Drive& turn : drives(step.turns)) {
      const Lanes angle_deg = load_samples(turn.samples + frames.first + i, frames.count - i);
      q = turned_about(q, turn.axis, sincos_deg(0.5 * angle_deg));
    }
    store(own.w, i, q.w);
    store(own.x, i, q.x);
    store(own.y, i, q.y);
    store(own.z, i, q.z);
  }
}

}  // namespace marey
