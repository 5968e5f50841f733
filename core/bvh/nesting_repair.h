#pragma once

#include "core/bvh/hierarchy_text.h"
#include "core/bvh/report.h"

namespace marey {

/// Undoes blocks that were closed too early. A joint without child and end site that is closed right before the next
/// joint or end site, in a tree with more '}' than '{', was meant to hold what follows. The early '}' are taken away
/// only if the surplus explains every such place; a tree whose leaves have no End Site by habit is left as it is.
void join_blocks_closed_early(HierarchyText& hierarchy, Report& report);

}  // namespace marey
