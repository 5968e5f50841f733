#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/kinematics/block_kernels.h"
#include "core/motion/motion.h"
#include "core/skeleton/position_rule.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// Forward kinematics of a block of consecutive frames at once, as structure of arrays: each quantity of a joint is an
/// array over the frames of the block, so every step of the arithmetic fills whole SIMD registers.
///
/// Memory grows with the depth of the tree (3.5 kB per level) and its channels, not with the number of frames: nodes
/// come depth first, so only the ancestors of the present node are kept. All of it is allocated on construction.
class FrameBlock {
 public:
  static constexpr int kMaxFrames = kMostBlockFrames;

  using Column = BlockColumn;
  /// World position of a node, in file units.
  using Positions = PositionColumns;

  /// Prepares to compute `nodes`: in file order, and with each node its parent. Skeleton and motion must outlive the
  /// block.
  FrameBlock(const Skeleton& skeleton, const Motion& motion, PositionRule rule, std::span<const NodeIndex> nodes);
  /// All nodes.
  FrameBlock(const Skeleton& skeleton, const Motion& motion, PositionRule rule);

  /// Calls visit(node, positions) for each node in order. 1 <= frames.count <= kMaxFrames; entries of the columns from
  /// frames.count on are meaningless.
  template <class Visit>
  void compute(FrameRange frames, Visit visit) {
    for (const Step& step : steps_) {
      place(step, frames);
      if (step.turns_children) turn(step, frames);
      visit(step.node, ancestors_[idx(step.level)].positions);
    }
  }

 private:
  // World transform of a joint.
  struct JointColumns {
    QuaternionColumns rotation;
    Positions positions;
  };
  // A channel that moves its joint. `samples` is the curve over the whole motion.
  struct Drive {
    Axis axis;
    const double* samples;
  };
  // Part of drives_.
  struct Drives {
    std::size_t first = 0;
    std::size_t count = 0;
  };
  struct Step {
    NodeIndex node;
    int level;  // place of the node in ancestors_; that of its parent is level - 1
    bool turns_children;
    bool positions_add;
    glm::dvec3 offset;
    Drives moves;
    Drives turns;
  };

  void add_step(const Skeleton& skeleton, const Motion& motion, PositionRule rule, NodeIndex node);
  template <class Wanted>
  Drives add_drives(const Skeleton& skeleton, const Motion& motion, JointIndex joint, Wanted wanted);
  [[nodiscard]] std::span<const Drive> drives(Drives part) const {
    return std::span(drives_).subspan(part.first, part.count);
  }
  void place(const Step& step, FrameRange frames);
  void turn(const Step& step, FrameRange frames);
  void fetch_ahead(const double* samples, FrameIndex first) const;

  FrameIndex frame_count_;
  const BlockKernels& kernels_ = block_kernels();
  Positions local_;
  Column half_sines_;  // of the angles of one channel
  Column half_cosines_;
  std::vector<Drive> drives_;
  std::vector<Step> steps_;
  std::vector<JointColumns> ancestors_;  // [0] is the world itself
};

}  // namespace marey
