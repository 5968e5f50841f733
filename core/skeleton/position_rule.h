#pragma once

namespace marey {

/// What the position channels of a joint mean beside its OFFSET; real tools disagree (Blender and assimp replace,
/// three.js adds). An axis without a position channel keeps its OFFSET under either rule.
enum class PositionRule {
  Replace,  ///< the channel is the position in the parent's frame
  Add,      ///< the channel is added to OFFSET
};

}  // namespace marey
