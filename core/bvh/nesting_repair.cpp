#include "core/bvh/nesting_repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/base/index.h"

namespace marey {
namespace {

/// The events of one tree: [first, end).
struct EventRange {
  int first = 0;
  int end = 0;
};

bool opens_root(const HierarchyText& hierarchy, int event) {
  const BraceEvent& brace = hierarchy.events[idx(event)];
  return brace.closings == 0 && brace.block != kNamelessBlock &&
         hierarchy.blocks[idx(brace.block)].kind == RawBlock::Kind::Root;
}

/// How many '}' find nothing to close, and which event holds the last of them.
struct Surplus {
  int count = 0;
  int last_event = -1;
};

Surplus find_surplus(const HierarchyText& hierarchy, EventRange range) {
  Surplus surplus;
  int depth = 0;
  for (int i = range.first; i < range.end; ++i) {
    const BraceEvent& brace = hierarchy.events[idx(i)];
    const bool has_body = brace.block == kNamelessBlock || hierarchy.blocks[idx(brace.block)].has_body;
    if (brace.closings == 0) depth += has_body ? 1 : 0;
    if (brace.closings > depth) {
      surplus.count += brace.closings - depth;
      surplus.last_event = i;
    }
    if (brace.closings > 0) depth = std::max(0, depth - brace.closings);
  }
  return surplus;
}

/// True if the event closes a childless joint right before the next block opens.
bool closes_early(const HierarchyText& hierarchy, int event, EventRange range) {
  if (event <= range.first || event + 1 >= range.end || hierarchy.events[idx(event)].closings != 1) return false;
  const BraceEvent& before = hierarchy.events[idx(event - 1)];
  const BraceEvent& behind = hierarchy.events[idx(event + 1)];
  if (before.closings > 0 || before.block == kNamelessBlock || behind.closings > 0) return false;
  if (behind.block == kNamelessBlock) return false;
  const RawBlock& block = hierarchy.blocks[idx(before.block)];
  return block.kind == RawBlock::Kind::Joint && block.has_body && !block.has_child;
}

std::string description(const RawBlock& block) {
  return block.kind == RawBlock::Kind::EndSite ? "End Site" : fmt::format("'{}'", shown(block.name));
}

void join(HierarchyText& hierarchy, int event, Report& report) {
  const RawBlock& block = hierarchy.blocks[idx(hierarchy.events[idx(event - 1)].block)];
  const RawBlock& next = hierarchy.blocks[idx(hierarchy.events[idx(event + 1)].block)];
  const std::string found = description(next);
  report.add_each(DiagnosticCode::JoinedTree, hierarchy.events[idx(event)].place,
                  fmt::format("{} is closed before it has a child, and a later '}}' is left over; {} was nested in it.",
                              description(block), found),
                  found, "}");
}

void join_in_tree(HierarchyText& hierarchy, EventRange range, std::vector<bool>& taken_away, Report& report) {
  const Surplus surplus = find_surplus(hierarchy, range);
  std::vector<int> early;
  for (int i = range.first; i < std::min(range.end, surplus.last_event); ++i) {
    if (closes_early(hierarchy, i, range)) early.push_back(i);
  }
  if (size_of(early) > surplus.count) return;
  for (const int event : early) {
    join(hierarchy, event, report);
    taken_away[idx(event)] = true;
    hierarchy.patches.give_up();  // the indent would tell of another tree
  }
}

}  // namespace

void join_blocks_closed_early(HierarchyText& hierarchy, Report& report) {
  const int count = size_of(hierarchy.events);
  std::vector<bool> taken_away(idx(count), false);
  for (EventRange range; range.first < count; range.first = range.end) {
    range.end = range.first + 1;
    while (range.end < count && !opens_root(hierarchy, range.end)) ++range.end;
    join_in_tree(hierarchy, range, taken_away, report);
  }
  std::vector<BraceEvent> kept;
  for (int i = 0; i < count; ++i) {
    if (!taken_away[idx(i)]) kept.push_back(hierarchy.events[idx(i)]);
  }
  hierarchy.events = std::move(kept);
}

}  // namespace marey
