#pragma once

#include <cstddef>

namespace marey {

/// Position of a joint in a Skeleton, 0-based, file order (depth first). Identity of a joint: names may repeat.
using JointIndex = int;
/// Position of a node (joint or end site) in a Skeleton, 0-based, file order (depth first).
using NodeIndex = int;
/// Position of a channel in a Motion, 0-based, the order of the columns in a BVH file.
using ChannelIndex = int;
/// Position of a frame in a Motion, 0-based. People see it plus one.
using FrameIndex = int;

/// Parent of a root joint or root node.
inline constexpr int kNoParent = -1;

/// An index that is known to be >= 0, as the standard containers want it.
[[nodiscard]] constexpr std::size_t idx(int index) { return static_cast<std::size_t>(index); }

/// Size of a container as an int; containers of Marey hold fewer than 2^31 elements where this is used.
template <class Container>
[[nodiscard]] constexpr int size_of(const Container& container) {
  return static_cast<int>(container.size());
}

/// Half-open range of frames [first, first + count).
struct FrameRange {
  FrameIndex first = 0;
  int count = 0;

  [[nodiscard]] constexpr FrameIndex end() const { return first + count; }
  [[nodiscard]] constexpr bool contains(FrameIndex frame) const { return frame >= first && frame < end(); }
  friend constexpr bool operator==(const FrameRange&, const FrameRange&) = default;
};

}  // namespace marey
