#pragma once

#include "core/bvh/hierarchy_build.h"
#include "core/bvh/report.h"
#include "core/motion/motion.h"
#include "core/skeleton/position_rule.h"

namespace marey {

/// Notes what is legal but unusual in a tree: leaves without End Site, bones without length, double names ...
void note_tree_habits(const Hierarchy& hierarchy, Report& report);

/// What the names are read in: a guess from all of them, reported unless they are UTF-8.
[[nodiscard]] CharacterSet find_character_set_of_names(const Hierarchy& hierarchy, Report& report);

/// Decides for each OFFSET with several readings: the first reading whose bone lies in the plane of the motion, if all
/// rotation is about one axis; else the first of all. Reports each decision.
void settle_open_offsets(Hierarchy& hierarchy, const Motion& motion, Report& report);

/// What the position channels of the joints mean. Joints below the root vote: values nearer to OFFSET replace it, values
/// nearer to 0 add to it. Where there are both and those for adding are all exactly 0, each joint gets its own way and is
/// marked so in the skeleton; else the majority decides. Reported wherever the rules would differ.
[[nodiscard]] PositionRule settle_position_rule(Hierarchy& hierarchy, const Motion& motion, Report& report);

}  // namespace marey
