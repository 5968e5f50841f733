#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/editing/body_carrying.h"
#include "core/editing/name_match.h"
#include "core/editing/operations/families.h"
#include "core/editing/operations/figure_edit.h"
#include "core/editing/operations/new_samples.h"
#include "core/motion/sampling.h"
#include "core/text/utf8.h"

namespace marey {
namespace {

using Outcome = Result<OperationOutcome>;

Error refusal(std::string message) { return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; }

// What the star of a pattern stands for in a name; nothing where the name does not fit. Without a star: "".
std::optional<std::string> star_of(std::string_view pattern, std::string_view name) {
  if (!matches_pattern(pattern, name)) return std::nullopt;
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos) return std::string();
  return std::string(name.substr(star, name.size() - (pattern.size() - 1)));
}

std::string renamed(std::string_view to, const std::string& star) {
  std::string name;
  for (const char c : to) name += c == '*' ? star : std::string(1, c);
  return name;
}

Status check_name(const Clip& clip, std::string_view name) {
  const bool has_letters = name.find_first_not_of(" \t") != std::string_view::npos;
  const bool is_printable = std::none_of(name.begin(), name.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f || c == '{' || c == '}';
  });
  if (!has_letters || !is_printable) return refusal(fmt::format("\"{}\" cannot be the name of a joint.", name));
  if (clip.settings.names_in != CharacterSet::Utf8 && !is_ascii(name)) {
    return refusal(fmt::format("\"{}\" has letters that are written in ASCII only, as the names are not in UTF-8.", name));
  }
  return {};
}

Outcome make_rename(const OperationCall& call) {
  const Skeleton& skeleton = call.clip.skeleton;
  const std::string& from = call.text("from");
  const std::string& to = call.text("to");
  if (std::count(from.begin(), from.end(), '*') > 1) return refusal("'from' has one star at most.");
  FigureDraft draft = take_apart(call.clip);
  int changed = 0;
  for (const JointIndex joint : call.target.joints) {
    const std::optional<std::string> star = star_of(from, skeleton.name(joint));
    if (!star) continue;
    const std::string name = renamed(to, *star);
    if (Status status = check_name(call.clip, name); !status) return status.error();
    draft.nodes[idx(skeleton.node_of(joint))].name_bytes = name;
    ++changed;
  }
  if (changed == 0) return refusal(fmt::format("No joint of the target is called \"{}\".", from));
  return make_figure_edit(call, std::move(draft), {});
}

Outcome make_scale_figure(const OperationCall& call) {
  const double factor = call.number("factor");
  if (factor == 1.0) return OperationOutcome{};
  OperationOutcome outcome;
  outcome.edit.name = call.operation.label;
  for (NodeIndex node = 0; node < call.clip.skeleton.node_count(); ++node) {
    outcome.edit.offsets.push_back({node, factor * call.clip.skeleton.node(node).offset});
  }
  for (ChannelIndex channel = 0; channel < call.clip.motion.channel_count(); ++channel) {
    if (!is_position(call.clip.skeleton.channel(channel).kind)) continue;
    const std::span<const double> before = call.clip.motion.channel_samples(channel);
    SamplesChange change{channel, 0, {before.begin(), before.end()}};
    for (double& value : change.values) value *= factor;
    outcome.edit.samples.push_back(std::move(change));
  }
  if (call.yes("unit")) {
    outcome.edit.settings = call.clip.settings;
    outcome.edit.settings->metres_per_unit /= factor;
    return outcome;
  }
  BodyChoice body = call.clip.body;
  scale_own_segments(body, factor);
  if (!(body == call.clip.body)) outcome.edit.body = std::move(body);
  return outcome;
}

double mean_of(std::span<const double> values) {
  double sum = 0.0;
  int count = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    // Relative to the first one, so that what is constant stays to the bit.
    sum += value - values.front();
    ++count;
  }
  return count > 0 && std::isfinite(values.front()) ? values.front() + sum / count : 0.0;
}

Outcome make_remove_positions(const OperationCall& call) {
  const Skeleton& skeleton = call.clip.skeleton;
  FigureDraft draft = take_apart(call.clip);
  int changed = 0;
  for (const JointIndex joint : call.target.joints) {
    if (!has_own_positions(skeleton, joint)) continue;
    NodeDraft& node = draft.nodes[idx(skeleton.node_of(joint))];
    const bool adds = skeleton.positions_add(joint, call.clip.settings.position_rule);
    for (const ChannelDraft& channel : node.channels) {
      if (!is_position(channel.kind) || channel.samples.empty()) continue;
      double& offset = node.offset[static_cast<int>(axis_of(channel.kind))];
      offset = (adds ? offset : 0.0) + mean_of(channel.samples);
    }
    std::erase_if(node.channels, [](const ChannelDraft& channel) { return is_position(channel.kind); });
    ++changed;
  }
  if (changed == 0) return OperationOutcome{};
  return make_figure_edit(call, std::move(draft), {}, Points::MayMove);
}

// The child turns as its parent and itself did together.
void take_rotation_over(const OperationCall& call, JointIndex parent, JointIndex child, NodeDraft& node,
                        std::vector<std::string>& notes) {
  const Clip& clip = call.clip;
  const auto euler = find_euler_channels(clip.skeleton, child);
  if (!euler || euler->count < 3) {
    notes.push_back(fmt::format("'{}' has not the rotation channels to take over what '{}' did.", clip.skeleton.name(child),
                                clip.skeleton.name(parent)));
    return;
  }
  glm::dvec3 previous(0.0);
  for (FrameIndex frame = 0; frame < clip.motion.frame_count(); ++frame) {
    const glm::dquat above = joint_rotation(clip.skeleton, clip.motion, parent, frame);
    const glm::dquat own = joint_rotation(clip.skeleton, clip.motion, child, frame);
    const glm::dmat3 rotation = glm::mat3_cast(glm::normalize(above * own));
    if (!std::isfinite(rotation[0][0])) continue;
    previous = euler_near(euler->order, rotation, previous);
    for (int i = 0; i < 3; ++i) {
      const ChannelIndex place = euler->channels[i] - clip.skeleton.first_channel(child);
      node.channels[idx(place)].samples[idx(frame)] = previous[i];
    }
  }
}

// Nodes in their order without one of them; whoever hung on it hangs on its parent.
void take_out(FigureDraft& draft, int taken) {
  const int parent = draft.nodes[idx(taken)].parent;
  const glm::dvec3 offset = draft.nodes[idx(taken)].offset;
  for (NodeDraft& node : draft.nodes) {
    if (node.parent == taken) {
      node.parent = parent;
      node.offset += offset;
    }
    if (node.parent > taken) --node.parent;
  }
  draft.nodes.erase(draft.nodes.begin() + taken);
}

Outcome make_delete_joint(const OperationCall& call) {
  const Skeleton& skeleton = call.clip.skeleton;
  if (call.target.joints.size() != 1) return refusal("Name the one joint to delete: joints=NAME.");
  const JointIndex joint = call.target.joints[0];
  const JointIndex parent = skeleton.parent(joint);
  if (parent == kNoParent) return refusal("A root cannot be deleted.");
  FigureDraft draft = take_apart(call.clip);
  std::vector<std::string> notes;
  for (JointIndex child = joint + 1; child < skeleton.subtree_end(joint); ++child) {
    if (skeleton.parent(child) == joint) {
      take_rotation_over(call, joint, child, draft.nodes[idx(skeleton.node_of(child))], notes);
    }
  }
  take_out(draft, skeleton.node_of(joint));
  return make_figure_edit(call, std::move(draft), std::move(notes), Points::MayMove);
}

Outcome make_insert_joint(const OperationCall& call) {
  const Skeleton& skeleton = call.clip.skeleton;
  if (call.target.joints.size() != 1) return refusal("Name the one joint above which the new one comes: joints=NAME.");
  const JointIndex joint = call.target.joints[0];
  if (skeleton.parent(joint) == kNoParent) return refusal("Above a root there is no bone.");
  if (has_own_positions(skeleton, joint)) return refusal("The joint has position channels, so its bone has no fixed length.");
  if (Status status = check_name(call.clip, call.text("name")); !status) return status.error();
  FigureDraft draft = take_apart(call.clip);
  const int place = skeleton.node_of(joint);
  const double share = call.number("at");
  NodeDraft added{draft.nodes[idx(place)].parent, false, call.text("name"), share * draft.nodes[idx(place)].offset, false, {}, kNoParent};
  for (const ChannelKind kind : {ChannelKind::Zrotation, ChannelKind::Xrotation, ChannelKind::Yrotation}) {
    added.channels.push_back({kind, {}, std::vector<double>(idx(call.clip.motion.frame_count()))});
  }
  for (NodeDraft& node : draft.nodes) node.parent += node.parent >= place ? 1 : 0;
  draft.nodes[idx(place)].parent = place;
  draft.nodes[idx(place)].offset -= added.offset;
  draft.nodes.insert(draft.nodes.begin() + place, std::move(added));
  return make_figure_edit(call, std::move(draft), {});
}

glm::dquat world_rotation(const Clip& clip, JointIndex joint, FrameIndex frame) {
  glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
  for (JointIndex above = joint; above != kNoParent; above = clip.skeleton.parent(above)) {
    rotation = joint_rotation(clip.skeleton, clip.motion, above, frame) * rotation;
  }
  return glm::normalize(rotation);
}

glm::dvec3 rest_position(const Skeleton& skeleton, JointIndex joint) {
  glm::dvec3 position(0.0);
  for (JointIndex above = joint; above != kNoParent; above = skeleton.parent(above)) position += skeleton.offset(above);
  return position;
}

// The joint turns in the world as it did.
void keep_world_rotation(const Clip& clip, const EulerChannels& euler, JointIndex joint, JointIndex parent, NodeDraft& node) {
  glm::dvec3 previous(0.0);
  for (FrameIndex frame = 0; frame < clip.motion.frame_count(); ++frame) {
    const glm::dquat local = glm::conjugate(world_rotation(clip, parent, frame)) * world_rotation(clip, joint, frame);
    const glm::dmat3 rotation = glm::mat3_cast(glm::normalize(local));
    if (!std::isfinite(rotation[0][0])) continue;
    previous = euler_near(euler.order, rotation, previous);
    for (int i = 0; i < 3; ++i) {
      node.channels[idx(euler.channels[i] - clip.skeleton.first_channel(joint))].samples[idx(frame)] = previous[i];
    }
  }
}

std::optional<JointIndex> find_joint(const Skeleton& skeleton, std::string_view name) {
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    if (skeleton.name(joint) == name) return joint;
  }
  return std::nullopt;
}

Outcome make_reparent(const OperationCall& call) {
  const Skeleton& skeleton = call.clip.skeleton;
  if (call.target.joints.size() != 1) return refusal("Name the one joint to hang elsewhere: joints=NAME.");
  const JointIndex joint = call.target.joints[0];
  const std::optional<JointIndex> parent = find_joint(skeleton, call.text("to"));
  if (!parent) return refusal(fmt::format("No joint is called \"{}\".", call.text("to")));
  if (*parent >= joint && *parent < skeleton.subtree_end(joint)) return refusal("A joint cannot hang on itself or on one below it.");
  if (skeleton.parent(joint) == kNoParent) return refusal("A root cannot hang on another joint.");
  if (skeleton.parent(joint) == *parent) return OperationOutcome{};
  const auto euler = find_euler_channels(skeleton, joint);
  if (!euler || euler->count < 3 || has_own_positions(skeleton, joint)) {
    return refusal(fmt::format("'{}' has not the three rotation channels that this takes, or positions of its own.", skeleton.name(joint)));
  }
  FigureDraft draft = take_apart(call.clip);
  NodeDraft& node = draft.nodes[idx(skeleton.node_of(joint))];
  node.offset = rest_position(skeleton, joint) - rest_position(skeleton, *parent);
  keep_world_rotation(call.clip, *euler, joint, *parent, node);
  draft.move_subtree(skeleton.node_of(joint), skeleton.node_of(*parent));
  return make_figure_edit(call, std::move(draft), {}, Points::MayMove);
}

constexpr OperationParameter kRename[] = {
    {.name = "from", .label = "Name", .help = "A name, or a pattern with one star such as mixamorig:*.", .kind = ParameterKind::Text},
    {.name = "to", .label = "New name", .help = "A star in it is what the other star stood for.", .kind = ParameterKind::Text}};
constexpr OperationParameter kScaleFigure[] = {
    {.name = "factor", .label = "Factor", .help = "Of all lengths.", .initial = 1.0, .least = 1e-6, .most = 1e6},
    {.name = "unit", .label = "Change the unit", .help = "The file unit becomes as much smaller, so the figure is as tall as before.",
     .kind = ParameterKind::YesNo, .initial = 0.0, .most = 1.0}};
constexpr OperationParameter kInsertJoint[] = {
    {.name = "name", .label = "Name", .help = "Of the new joint.", .kind = ParameterKind::Text},
    {.name = "at", .label = "At", .help = "Where on the bone: 0 at the parent, 1 at the joint.", .initial = 0.5, .least = 0.0, .most = 1.0}};

constexpr OperationParameter kReparent[] = {
    {.name = "to", .label = "New parent", .help = "The joint that it is to hang on.", .kind = ParameterKind::Text}};

constexpr Operation kFigure[] = {
    {.id = "rename", .label = "Rename joints", .group = "Figure", .help = "Gives joints other names, by a pattern.",
     .reach = OperationReach::Figure, .parameters = kRename, .make = make_rename},
    {.id = "scale-figure", .label = "Scale figure", .group = "Figure", .help = "Makes all offsets and positions larger or smaller.",
     .reach = OperationReach::Clip, .parameters = kScaleFigure, .make = make_scale_figure},
    {.id = "remove-positions", .label = "Remove position channels", .group = "Figure",
     .help = "Leaves joints below the roots their rotations alone; the mean position becomes the offset.",
     .reach = OperationReach::Figure, .make = make_remove_positions},
    {.id = "delete-joint", .label = "Delete joint", .group = "Figure", .help = "Takes a joint out; its children take over.",
     .reach = OperationReach::Figure, .make = make_delete_joint},
    {.id = "insert-joint", .label = "Insert joint", .group = "Figure", .help = "Puts a joint into the bone above a joint.",
     .reach = OperationReach::Figure, .parameters = kInsertJoint, .make = make_insert_joint},
    {.id = "reparent", .label = "Hang joint elsewhere", .group = "Figure", .help = "Makes a joint the child of another one.",
     .reach = OperationReach::Figure, .parameters = kReparent, .make = make_reparent}};

}  // namespace

std::span<const Operation> figure_operations() { return kFigure; }

}  // namespace marey
