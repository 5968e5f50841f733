#pragma once

#include <span>

#include "core/motion/motion.h"
#include "core/skeleton/position_rule.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// World positions of all nodes over a range of frames, in file units.
/// `world_positions` holds [frame][node][x y z], frames.count * node_count * 3 values, nodes in the order of
/// Skeleton::nodes(). The range lies within the motion. Scratch memory is a fixed small block on the stack or in
/// the function's own buffers, independent of the number of frames.
void compute_world_positions(const Skeleton& skeleton, const Motion& motion, FrameRange frames, PositionRule rule,
                             std::span<double> world_positions);

/// The same in single precision, for drawing; computed in double, rounded once.
void compute_world_positions(const Skeleton& skeleton, const Motion& motion, FrameRange frames, PositionRule rule,
                             std::span<float> world_positions);

/// Path of one node over a range of frames, [frame][x y z]: frames.count * 3 values. Costs only the node's ancestors.
void compute_node_path(const Skeleton& skeleton, const Motion& motion, FrameRange frames, PositionRule rule,
                       NodeIndex node, std::span<float> world_positions);

}  // namespace marey
