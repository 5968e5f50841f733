#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/editing/edit.h"

namespace marey {

/// A channel of a draft with the samples that it will have.
struct ChannelDraft {
  ChannelKind kind = ChannelKind::Other;
  std::string other_name;
  std::vector<double> samples;
};

/// A joint or an end site of a draft.
struct NodeDraft {
  int parent = kNoParent;  ///< its place among the nodes
  bool is_end_site = false;
  std::string name_bytes;
  glm::dvec3 offset{0.0};
  bool positions_add = false;
  std::vector<ChannelDraft> channels;
  NodeIndex origin = kNoParent;  ///< the node of the clip that it was; kNoParent for a new one
};

/// A figure and its motion taken apart, to be changed and put together again: a Skeleton itself cannot be changed. Nodes stand
/// in file order, depth first, so that a node's parent stands before it and a subtree is contiguous.
struct FigureDraft {
  std::vector<NodeDraft> nodes;

  /// One past the last node below `node`.
  [[nodiscard]] int subtree_end(int node) const;
  /// Hangs a node, with all that is below it, on another joint, which is not below it, as its last child.
  void move_subtree(int node, int new_parent);
};

[[nodiscard]] FigureDraft take_apart(const Clip& clip);

/// The change to the drafted figure. Error InvalidSkeleton as SkeletonBuilder has it.
[[nodiscard]] Result<FigureChange> put_together(const Clip& clip, FigureDraft draft);

}  // namespace marey
