#include "core/bvh/clip_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "core/base/counted.h"
#include "core/base/index.h"
#include "core/base/text_cursor.h"
#include "core/text/character_set_guess.h"
#include "core/text/utf8.h"

namespace marey {
namespace {

// Findings quote the bytes of the file: what they stand for is known later, and people can change it.

std::string_view bytes_of(const Skeleton& skeleton, JointIndex joint) {
  return trimmed(skeleton.node(skeleton.node_of(joint)).name_bytes);
}

std::string quoted_name(const Skeleton& skeleton, JointIndex joint) { return shown(bytes_of(skeleton, joint)); }

std::string label(const Skeleton& skeleton, NodeIndex node) {
  const JointIndex joint = skeleton.node(node).joint;
  const std::string end = skeleton.node(node).is_end_site ? node_label(skeleton, node).substr(skeleton.name(joint).size())
                                                          : std::string();
  return shown(std::string(bytes_of(skeleton, joint)) + end);
}

struct NodeCensus {
  std::vector<int> children;   ///< per joint
  std::vector<int> end_sites;  ///< per joint
};

NodeCensus count_nodes(const Skeleton& skeleton) {
  NodeCensus census{std::vector<int>(idx(skeleton.joint_count())), std::vector<int>(idx(skeleton.joint_count()))};
  for (const Node& node : skeleton.nodes()) {
    if (node.is_end_site) ++census.end_sites[idx(node.joint)];
  }
  for (const JointIndex parent : skeleton.parents()) {
    if (parent != kNoParent) ++census.children[idx(parent)];
  }
  return census;
}

void note_ends(const Hierarchy& hierarchy, Report& report) {
  const Skeleton& skeleton = hierarchy.skeleton;
  const NodeCensus census = count_nodes(skeleton);
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const std::size_t place = hierarchy.node_places[idx(skeleton.node_of(joint))];
    const int ends = census.end_sites[idx(joint)];
    const std::string name = quoted_name(skeleton, joint);
    if (census.children[idx(joint)] == 0 && ends == 0) {
      report.add(DiagnosticCode::LeafWithoutEndSite, place,
                 fmt::format("'{}' ends a limb but has no End Site; its last bone has no direction.", name), "End Site", "");
    }
    if (census.children[idx(joint)] > 0 && ends > 0) {
      report.add(DiagnosticCode::EndSiteBesideChildren, place,
                 fmt::format("'{}' has joints and an End Site; both are kept, some other programs lose one.", name),
                 "joints or an End Site", "both");
    }
    if (ends > 1) {
      report.add(DiagnosticCode::SeveralEndSites, place,
                 fmt::format("'{}' has {} end sites; all are kept, most other programs lose some.", name, ends),
                 "one End Site", fmt::format("{}", ends));
    }
  }
}

void note_names(const Hierarchy& hierarchy, Report& report) {
  const Skeleton& skeleton = hierarchy.skeleton;
  std::unordered_set<std::string_view> seen;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const std::string_view name = bytes_of(skeleton, joint);
    if (name.empty() || seen.insert(name).second) continue;
    report.add_each(DiagnosticCode::DuplicateName, hierarchy.node_places[idx(skeleton.node_of(joint))],
                    fmt::format("Another joint is called '{}' too; programs that find joints by name mix them up.",
                                shown(name)),
                    "a name of its own", shown(name));
  }
}

void note_repeated_channels(const Hierarchy& hierarchy, Report& report) {
  const Skeleton& skeleton = hierarchy.skeleton;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    std::array<int, 9> count{};
    for (const Channel& channel : skeleton.channels(joint)) {
      if (channel.kind == ChannelKind::Other || ++count[static_cast<std::size_t>(channel.kind)] != 2) continue;
      report.add(DiagnosticCode::RepeatedChannel, hierarchy.node_places[idx(skeleton.node_of(joint))],
                 fmt::format("'{}' has {} twice; both are kept and applied one after the other.",
                             quoted_name(skeleton, joint), channel_keyword(channel.kind)),
                 "", channel_keyword(channel.kind).data());
    }
  }
}

void note_scale_channels(const Hierarchy& hierarchy, Report& report) {
  const Skeleton& skeleton = hierarchy.skeleton;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const auto channels = skeleton.channels(joint);
    const auto scale = std::find_if(channels.begin(), channels.end(), [](const Channel& c) { return is_scale(c.kind); });
    if (scale == channels.end()) continue;
    report.add(DiagnosticCode::ScaleChannel, hierarchy.node_places[idx(skeleton.node_of(joint))],
               fmt::format("'{}' has scale channels; they are kept and saved, but not applied to the figure.",
                           quoted_name(skeleton, joint)),
               "positions and rotations", std::string(channel_keyword(scale->kind)));
  }
}

/// The one axis about which anything rotates; nothing if there is none or more than one.
std::optional<Axis> only_rotation_axis(const Skeleton& skeleton, const Motion& motion) {
  std::array<bool, 3> moves{};
  for (ChannelIndex c = 0; c < skeleton.channel_count(); ++c) {
    if (!is_rotation(skeleton.channel(c).kind)) continue;
    const auto samples = motion.channel_samples(c);
    const bool any = std::any_of(samples.begin(), samples.end(), [](double v) { return v != 0.0; });
    if (any) moves[static_cast<std::size_t>(axis_of(skeleton.channel(c).kind))] = true;
  }
  if (std::count(moves.begin(), moves.end(), true) != 1) return std::nullopt;
  return static_cast<Axis>(std::find(moves.begin(), moves.end(), true) - moves.begin());
}

/// Mean distance of a channel's samples from 0 and from `offset`, over a few hundred frames.
struct Distances {
  double from_zero = 0.0;
  double from_offset = 0.0;
};

Distances measure(std::span<const double> samples, double offset) {
  constexpr std::size_t kMostFrames = 256;
  const std::size_t step = std::max<std::size_t>(1, samples.size() / kMostFrames);
  Distances sum;
  for (std::size_t i = 0; i < samples.size(); i += step) {
    sum.from_zero += std::abs(samples[i]);
    sum.from_offset += std::abs(samples[i] - offset);
  }
  return sum;
}

/// +1: the joint's positions replace its OFFSET; -1: they add to it; 0: the joint does not tell.
int vote_of(const Skeleton& skeleton, const Motion& motion, JointIndex joint) {
  Distances sum;
  for (int i = 0; i < skeleton.channel_count(joint); ++i) {
    const ChannelIndex channel = skeleton.first_channel(joint) + i;
    const ChannelKind kind = skeleton.channel(channel).kind;
    if (!is_position(kind)) continue;
    const Distances distances =
        measure(motion.channel_samples(channel), skeleton.offset(joint)[static_cast<int>(axis_of(kind))]);
    sum.from_zero += distances.from_zero;
    sum.from_offset += distances.from_offset;
  }
  return sum.from_offset < sum.from_zero ? 1 : sum.from_offset > sum.from_zero ? -1 : 0;
}

bool rests_at_zero(const Skeleton& skeleton, const Motion& motion, JointIndex joint) {
  for (int i = 0; i < skeleton.channel_count(joint); ++i) {
    const ChannelIndex channel = skeleton.first_channel(joint) + i;
    const std::span<const double> samples = motion.channel_samples(channel);
    if (!is_position(skeleton.channel(channel).kind)) continue;
    if (std::any_of(samples.begin(), samples.end(), [](double sample) { return sample != 0.0; })) return false;
  }
  return true;
}

struct Votes {
  int replace = 0;
  int add = 0;
  std::vector<JointIndex> resting;  // those for adding whose positions are all 0
  NodeIndex first_node = kNoParent;
};

Votes count_votes(const Skeleton& skeleton, const Motion& motion) {
  Votes votes;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    if (skeleton.parent(joint) == kNoParent) continue;
    const int vote = vote_of(skeleton, motion, joint);
    votes.replace += vote > 0 ? 1 : 0;
    votes.add += vote < 0 ? 1 : 0;
    if (vote < 0 && rests_at_zero(skeleton, motion, joint)) votes.resting.push_back(joint);
    if (vote != 0 && votes.first_node == kNoParent) votes.first_node = skeleton.node_of(joint);
  }
  return votes;
}

PositionRule rule_of(const Votes& votes) {
  if (votes.replace > 0 && votes.add > 0 && size_of(votes.resting) == votes.add) return PositionRule::PerJoint;
  return votes.add > votes.replace ? PositionRule::Add : PositionRule::Replace;
}

void note_rule_for_all(const Votes& votes, PositionRule rule, std::size_t place, Report& report) {
  if (votes.add > 0 && votes.replace > 0) {
    report.add(DiagnosticCode::PositionsAmbiguous, place,
               fmt::format("The positions of {} look as if they replace OFFSET, those of {} as if they add to it; they {} "
                           "for all.",
                           counted(votes.replace, "joint"), counted(votes.add, "joint"),
                           rule == PositionRule::Add ? "are added to it" : "replace it"));
  } else if (rule == PositionRule::Add) {
    report.add(DiagnosticCode::PositionsAddToOffset, place,
               fmt::format("The position channels of {} stay near 0; they are added to OFFSET.", counted(votes.add, "joint")));
  } else {
    report.add_each(DiagnosticCode::PositionsReplaceOffset, place,
                    fmt::format("The position channels of {} below the root stay near OFFSET; they replace it.",
                                counted(votes.replace, "joint")));
  }
}

void note_root_offset(const Hierarchy& hierarchy, Report& report) {
  const Skeleton& skeleton = hierarchy.skeleton;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    if (skeleton.parent(joint) != kNoParent || skeleton.offset(joint) == glm::dvec3(0.0)) continue;
    const auto channels = skeleton.channels(joint);
    if (std::none_of(channels.begin(), channels.end(), [](const Channel& c) { return is_position(c.kind); })) continue;
    report.add_each(DiagnosticCode::PositionsReplaceOffset, hierarchy.node_places[idx(skeleton.node_of(joint))],
                    fmt::format("The root '{}' has an OFFSET and position channels; the channels replace it. Programs "
                                "that add both show the figure moved.",
                                quoted_name(skeleton, joint)));
  }
}

}  // namespace

void note_tree_habits(const Hierarchy& hierarchy, Report& report) {
  const Skeleton& skeleton = hierarchy.skeleton;
  const auto roots = std::count(skeleton.parents().begin(), skeleton.parents().end(), kNoParent);
  if (roots > 1) {
    report.add(DiagnosticCode::SeveralRoots, hierarchy.node_places.front(),
               fmt::format("The file has {} roots; all are kept, many other programs read the first only.", roots),
               "one ROOT", fmt::format("{}", roots));
  }
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (skeleton.node(node).parent == kNoParent || skeleton.node(node).offset != glm::dvec3(0.0)) continue;
    report.add(DiagnosticCode::ZeroLengthBone, hierarchy.node_places[idx(node)],
               fmt::format("The bone to '{}' has no length.", label(skeleton, node)));
  }
  note_ends(hierarchy, report);
  note_names(hierarchy, report);
  note_repeated_channels(hierarchy, report);
  note_scale_channels(hierarchy, report);
}

CharacterSet find_character_set_of_names(const Hierarchy& hierarchy, Report& report) {
  const std::vector<std::string_view> names = name_bytes_of(hierarchy.skeleton);
  const CharacterSet set = guess_character_set(names);
  const auto first = std::find_if_not(names.begin(), names.end(), is_utf8);
  if (first == names.end()) return set;
  const CharacterSetTraits& traits = traits_of(set);
  const auto count = std::count_if(first, names.end(), [](std::string_view name) { return !is_utf8(name); });
  report.add(DiagnosticCode::NamesNotUtf8, hierarchy.node_places[static_cast<std::size_t>(first - names.begin())],
             fmt::format("{} not UTF-8; on opening, all names were read as {} ({}). They are saved as they stand in the "
                         "file.",
                         count == 1 ? "1 name is" : fmt::format("{} names are", count), traits.label, traits.script),
             "UTF-8", std::string(traits.label));
  return set;
}

void settle_open_offsets(Hierarchy& hierarchy, const Motion& motion, Report& report) {
  if (hierarchy.open_offsets.empty()) return;
  const std::optional<Axis> axis = only_rotation_axis(hierarchy.skeleton, motion);
  for (const OpenOffset& open : hierarchy.open_offsets) {
    const std::vector<OffsetReading>& readings = open.block.offset_readings;
    const auto in_plane = std::find_if(readings.begin(), readings.end(), [&](const OffsetReading& reading) {
      return axis && reading.offset[static_cast<int>(*axis)] == 0.0;
    });
    const OffsetReading& chosen = in_plane == readings.end() ? readings.front() : *in_plane;
    hierarchy.skeleton.set_offset(open.node, chosen.offset);
    patch_offset(open.block.offset, open.block.offset_end, chosen, hierarchy.patches);
    report_offset_reading(description_of(open.block), open.block.offset_place, open.block.offset.count, chosen, report);
  }
}

PositionRule settle_position_rule(Hierarchy& hierarchy, const Motion& motion, Report& report) {
  const Votes votes = count_votes(hierarchy.skeleton, motion);
  const PositionRule rule = rule_of(votes);
  if (rule != PositionRule::Add) note_root_offset(hierarchy, report);
  if (votes.first_node == kNoParent) return rule;
  const std::size_t place = hierarchy.node_places[idx(votes.first_node)];
  if (rule != PositionRule::PerJoint) {
    note_rule_for_all(votes, rule, place, report);
    return rule;
  }
  for (const JointIndex joint : votes.resting) hierarchy.skeleton.set_positions_add(joint, true);
  report.add(DiagnosticCode::PositionsAmbiguous, place,
             fmt::format("The position channels of {} replace OFFSET; those of {} are all 0 beside an OFFSET and are added "
                         "to it.",
                         counted(votes.replace, "joint"), counted(votes.add, "joint")));
  return rule;
}

}  // namespace marey
