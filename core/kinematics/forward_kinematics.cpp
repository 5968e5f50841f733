#include "core/kinematics/forward_kinematics.h"

#include <algorithm>
#include <vector>

#include "core/kinematics/frame_block.h"

namespace marey {
namespace {

constexpr std::size_t kAxes = 3;

// Writes the positions of one node into an array of [frame][node][x y z] or [frame][x y z], `stride` numbers per frame.
template <class Number>
void write_positions(const FrameBlock::Positions& positions, int count, std::size_t stride, Number* out) {
  for (int i = 0; i < count; ++i, out += stride) {
    out[0] = static_cast<Number>(positions.x[idx(i)]);
    out[1] = static_cast<Number>(positions.y[idx(i)]);
    out[2] = static_cast<Number>(positions.z[idx(i)]);
  }
}

template <class Visit>
void for_each_block(FrameRange frames, Visit visit) {
  for (FrameIndex first = frames.first; first < frames.end(); first += FrameBlock::kMaxFrames) {
    visit(FrameRange{first, std::min(FrameBlock::kMaxFrames, frames.end() - first)});
  }
}

template <class Number>
void compute_positions(const Skeleton& skeleton, const Motion& motion, FrameRange frames, PositionRule rule,
                       std::span<Number> world_positions) {
  FrameBlock block(skeleton, motion, rule);
  const std::size_t stride = kAxes * idx(skeleton.node_count());
  Number* out = world_positions.data();
  for_each_block(frames, [&](FrameRange part) {
    block.compute(part, [&](NodeIndex node, const FrameBlock::Positions& positions) {
      write_positions(positions, part.count, stride, out + kAxes * idx(node));
    });
    out += stride * idx(part.count);
  });
}

std::vector<NodeIndex> with_ancestors(const Skeleton& skeleton, NodeIndex node) {
  std::vector<NodeIndex> chain;
  for (NodeIndex i = node; i != kNoParent; i = skeleton.node(i).parent) chain.push_back(i);
  std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace

void compute_world_positions(const Skeleton& skeleton, const Motion& motion, FrameRange frames, PositionRule rule,
                             std::span<double> world_positions) {
  compute_positions(skeleton, motion, frames, rule, world_positions);
}

void compute_world_positions(const Skeleton& skeleton, const Motion& motion, FrameRange frames, PositionRule rule,
                             std::span<float> world_positions) {
  compute_positions(skeleton, motion, frames, rule, world_positions);
}

void compute_node_path(const Skeleton& skeleton, const Motion& motion, FrameRange frames, PositionRule rule,
                       NodeIndex node, std::span<float> world_positions) {
  FrameBlock block(skeleton, motion, rule, with_ancestors(skeleton, node));
  float* out = world_positions.data();
  for_each_block(frames, [&](FrameRange part) {
    block.compute(part, [&](NodeIndex visited, const FrameBlock::Positions& positions) {
      if (visited == node) write_positions(positions, part.count, kAxes, out);
    });
    out += kAxes * idx(part.count);
  });
}

}  // namespace marey
