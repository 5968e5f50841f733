#include "core/bvh/hierarchy_build.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/counted.h"
#include "core/base/index.h"
#include "core/bvh/nesting_repair.h"
#include "core/skeleton/skeleton_builder.h"

namespace marey {
namespace {

class HierarchyBuilder {
 public:
  HierarchyBuilder(std::string_view text, HierarchyText hierarchy, const ReadLimits& limits, Report& report)
      : text_(text), hierarchy_(std::move(hierarchy)), indent_(find_indent(text, hierarchy_)), limits_(limits), report_(report) {}

  Hierarchy build();

 private:
  void read_end_sites_with_blocks_as_joints();
  void read_as_joint(RawBlock& block, const std::string& reason);
  void open(const BraceEvent& event);
  void open_joint(RawBlock& block);
  void add_end_site(const RawBlock& block);
  void close(const BraceEvent& event);
  void close_all(std::size_t place, bool at_end);
  void add_closing_braces(std::size_t place);
  void note_node(const RawBlock& block);
  glm::dvec3 offset_of(const RawBlock& block);

  std::string_view text_;
  HierarchyText hierarchy_;
  std::string indent_;  ///< per level
  const ReadLimits& limits_;
  Report& report_;
  SkeletonBuilder builder_;
  std::vector<bool> open_is_joint_;
  Hierarchy result_;
};

Hierarchy HierarchyBuilder::build() {
  result_.patches = hierarchy_.patches;
  read_end_sites_with_blocks_as_joints();
  for (const BraceEvent& event : hierarchy_.events) {
    if (report_.failed()) return {};
    if (event.closings > 0) {
      close(event);
    } else {
      open(event);
    }
  }
  if (!open_is_joint_.empty()) close_all(hierarchy_.end, hierarchy_.end >= text_.size());
  if (builder_.joint_count() == 0) {
    report_.fail(DiagnosticCode::MissingRoot, hierarchy_.end,
                 "The hierarchy has no joint, so there is no figure to show. A BVH file describes one below ROOT, before MOTION.",
                 "ROOT",
                 hierarchy_.end >= text_.size() ? "the end of the file" : "MOTION");
  }
  if (report_.failed()) return {};
  Result<Skeleton> skeleton = builder_.build();
  if (skeleton) {
    result_.skeleton = std::move(*skeleton);
  } else {
    report_.fail_without_place(skeleton.error().code, skeleton.error().message);
  }
  return std::move(result_);
}

/// What stands inside the braces of an End Site begins where the End Site is, so that is a joint.
void HierarchyBuilder::read_end_sites_with_blocks_as_joints() {
  for (std::size_t i = 0; i + 1 < hierarchy_.events.size(); ++i) {
    const BraceEvent& next = hierarchy_.events[i + 1];
    if (hierarchy_.events[i].closings > 0 || hierarchy_.events[i].block == kNamelessBlock) continue;
    RawBlock& block = hierarchy_.blocks[idx(hierarchy_.events[i].block)];
    const bool holds_block = block.has_body && next.closings == 0 && next.block != kNamelessBlock;
    if (block.kind != RawBlock::Kind::EndSite || !holds_block || !block.channels.empty()) continue;
    read_as_joint(block, "The end site has joints below it, so it was read as a joint.");
  }
}

void HierarchyBuilder::read_as_joint(RawBlock& block, const std::string& reason) {
  result_.patches.replace(block.place, block.keyword_end - block.place, block.name.empty() ? "JOINT End Site" : "JOINT");
  report_.add_each(DiagnosticCode::EndSiteWithChannels, block.place, reason, "JOINT", "End Site");
  block.kind = RawBlock::Kind::Joint;
  if (block.name.empty()) block.name = block.name_bytes = "End Site";
}

void HierarchyBuilder::open(const BraceEvent& event) {
  if (event.block == kNamelessBlock) {
    open_is_joint_.push_back(false);
    return;
  }
  RawBlock& block = hierarchy_.blocks[idx(event.block)];
  if (block.kind == RawBlock::Kind::Root && !open_is_joint_.empty()) close_all(block.place, false);
  if (block.kind == RawBlock::Kind::EndSite && !block.channels.empty()) {
    read_as_joint(block, "The end site has channels, so it was read as a joint.");
  }
  const bool is_joint = block.kind != RawBlock::Kind::EndSite;
  if (is_joint) {
    open_joint(block);
  } else {
    add_end_site(block);
  }
  if (block.has_body) {
    open_is_joint_.push_back(is_joint);
  } else if (is_joint) {
    builder_.close_joint();
  }
}

void HierarchyBuilder::open_joint(RawBlock& block) {
  if (builder_.open_depth() >= limits_.max_depth) {
    report_.fail(DiagnosticCode::LimitDepth, block.place,
                 fmt::format("The joints are nested more than {} deep, which is the limit for a file.", limits_.max_depth));
    return;
  }
  if (block.kind == RawBlock::Kind::Joint && builder_.open_depth() == 0) {
    result_.patches.replace(block.place, block.keyword_end - block.place, "ROOT");
    report_.add_each(DiagnosticCode::JointOutsideRoot, block.place,
                     fmt::format("JOINT '{}' stands outside of any ROOT; it was read as a root.", shown(block.name)),
                     "ROOT", "JOINT");
  }
  builder_.open_joint(std::string(block.name_bytes), offset_of(block));
  note_node(block);
  for (const RawChannel& channel : block.channels) {
    const bool other = channel.kind == ChannelKind::Other;
    builder_.add_channel(channel.kind, other ? std::string(channel.keyword) : std::string());
  }
  if (block.has_body && !block.has_channels) {
    report_.add_each(DiagnosticCode::MissingChannels, block.place,
                     fmt::format("'{}' has no CHANNELS line; it was read as having no channels.", shown(block.name)),
                     "CHANNELS", "");
  }
}

void HierarchyBuilder::add_end_site(const RawBlock& block) {
  if (builder_.open_depth() == 0) {
    result_.patches.give_up();
    report_.add_each(DiagnosticCode::UnexpectedToken, block.place, "This End Site belongs to no joint; it was left out.",
                     "ROOT", "End Site");
    return;
  }
  const glm::dvec3 offset = offset_of(block);
  builder_.add_end_site(offset, std::string(block.name_bytes));
  note_node(block);
}

void HierarchyBuilder::note_node(const RawBlock& block) {
  result_.node_places.push_back(block.place);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool as_written = block.offset.count == 3;
    result_.offset_slots.push_back(as_written ? block.offset.values[axis] : NumberSlot{});
  }
}

glm::dvec3 HierarchyBuilder::offset_of(const RawBlock& block) {
  glm::dvec3 offset(0.0);
  if (!block.has_offset) {
    if (block.has_body) {
      report_.add_each(DiagnosticCode::MissingOffset, block.place,
                       fmt::format("'{}' has no OFFSET; 0 0 0 was used.",
                                   block.kind == RawBlock::Kind::EndSite ? "End Site" : shown(block.name)),
                       "OFFSET", "");
    }
  } else if (block.offset.count == 3) {
    for (int axis = 0; axis < 3; ++axis) offset[axis] = block.offset.values[idx(axis)].value;
  } else {
    offset = block.offset_readings.front().offset;
    if (block.offset_readings.size() > 1) result_.open_offsets.push_back({size_of(result_.node_places), block});
  }
  return offset;
}

void HierarchyBuilder::close(const BraceEvent& event) {
  for (int i = 0; i < event.closings; ++i) {
    if (open_is_joint_.empty()) {
      std::size_t place = event.place;
      for (int passed = 0; passed < i; ++passed) place = text_.find('}', place + 1);
      std::size_t surplus = place;
      for (int left = event.closings - i; left > 0; --left, surplus = text_.find('}', surplus + 1)) {
        result_.patches.remove(surplus, 1);
      }
      report_.add_each(DiagnosticCode::SurplusClosingBrace, place,
                       fmt::format("{} '}}' too many; left out.", event.closings - i), "MOTION", "}");
      return;
    }
    if (open_is_joint_.back()) builder_.close_joint();
    open_is_joint_.pop_back();
  }
}

void HierarchyBuilder::close_all(std::size_t place, bool at_end) {
  const auto missing = open_is_joint_.size();
  add_closing_braces(place);
  if (at_end) {
    report_.add(DiagnosticCode::UnexpectedEnd, place,
                fmt::format("The file ends inside the hierarchy: {} '}}' {} missing and added. Joints behind this place are "
                            "lost.",
                            missing, missing == 1 ? "was" : "were"),
                "}", "the end of the file");
  } else {
    report_.add_each(DiagnosticCode::MissingClosingBrace, place,
                     fmt::format("{} '}}' {} missing before this place and added.", missing, missing == 1 ? "was" : "were"),
                     "}",
                     shown(TextCursor(text_, place).peek_word()));
  }
  while (builder_.open_depth() > 0) builder_.close_joint();
  open_is_joint_.clear();
}

/// Before the line of `place` where only blanks stand before it there.
void HierarchyBuilder::add_closing_braces(std::size_t place) {
  std::size_t at = place;
  while (at > 0 && is_blank(text_[at - 1]) && !is_line_end(text_[at - 1])) --at;
  const bool opens_line = at == 0 || is_line_end(text_[at - 1]);
  std::string braces = opens_line ? "" : "\n";
  for (std::size_t depth = open_is_joint_.size(); depth > 0; --depth) {
    braces += indent_at(indent_, depth - 1) + "}\n";
  }
  result_.patches.insert(opens_line ? at : place, braces);
}

}  // namespace

std::string find_indent(std::string_view text, const HierarchyText& hierarchy) {
  const auto first = std::find_if(hierarchy.blocks.begin(), hierarchy.blocks.end(),
                                  [](const RawBlock& block) { return block.has_offset; });
  if (first == hierarchy.blocks.end()) return "  ";
  const std::size_t place = first->offset_place;
  const std::string indent = indent_before(text, place);
  const bool alone = place > indent.size() && is_line_end(text[place - indent.size() - 1]);
  return alone && !indent.empty() ? indent : "  ";
}

Hierarchy build_hierarchy(std::string_view text, HierarchyText hierarchy, const ReadLimits& limits, Report& report) {
  join_blocks_closed_early(hierarchy, report);
  return HierarchyBuilder(text, std::move(hierarchy), limits, report).build();
}

}  // namespace marey
