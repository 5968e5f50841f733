#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/bvh/header_patch.h"
#include "core/bvh/hierarchy_text.h"
#include "core/bvh/limits.h"
#include "core/bvh/report.h"
#include "core/bvh/style.h"
#include "core/skeleton/skeleton.h"

namespace marey {

/// An OFFSET with several sensible readings; the motion decides, see settle_open_offsets().
struct OpenOffset {
  NodeIndex node = 0;
  RawBlock block;
};

/// The tree that a hierarchy section means.
struct Hierarchy {
  Skeleton skeleton;
  std::vector<std::size_t> node_places;  ///< of the keyword of each node
  std::vector<NumberSlot> offset_slots;  ///< three per node, where the text holds them
  std::vector<OpenOffset> open_offsets;
  HeaderPatches patches;  ///< where the text says something else than the skeleton
};

/// The blanks before the first OFFSET, if it stands alone in its line, else two.
[[nodiscard]] std::string find_indent(std::string_view text, const HierarchyText& hierarchy);

/// Builds the tree, with repairs of its nesting; nothing of use is in the result when the report has failed.
[[nodiscard]] Hierarchy build_hierarchy(std::string_view text, HierarchyText hierarchy, const ReadLimits& limits,
                                        Report& report);

}  // namespace marey
