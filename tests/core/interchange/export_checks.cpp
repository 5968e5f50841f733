#include "tests/core/interchange/export_checks.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/kinematics/pose.h"

namespace marey::test {
namespace {

bool is_root(const Skeleton& skeleton, JointIndex joint) { return skeleton.parent(joint) == kNoParent; }

int count_positions(const Skeleton& skeleton, JointIndex joint) {
  const auto channels = skeleton.channels(joint);
  return static_cast<int>(std::count_if(channels.begin(), channels.end(), [](const Channel& c) { return is_position(c.kind); }));
}

bool has_three_axes(const std::string& order) { return std::set<char>(order.begin(), order.end()).size() == 3 && order.size() == 3; }

bool has_word_letters(const std::string& name, const std::string& more) {
  const auto is_plain = [&more](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || more.find(c) != std::string::npos;
  };
  return !name.empty() && name.size() <= 63 && std::all_of(name.begin(), name.end(), is_plain);
}

int end_site_count(const Skeleton& skeleton, JointIndex joint) {
  const auto nodes = skeleton.nodes();
  return static_cast<int>(std::count_if(nodes.begin(), nodes.end(),
                                        [joint](const Node& n) { return n.is_end_site && n.joint == joint; }));
}

/// A fault of one joint, in a word.
std::string joint_fault(const Skeleton& skeleton, JointIndex joint, Requirement requirement) {
  const int positions = count_positions(skeleton, joint);
  const std::string order = euler_order_label(skeleton, joint);
  const bool is_leaf = skeleton.subtree_end(joint) == joint + 1;
  const int ends = end_site_count(skeleton, joint);
  const auto fault = [](bool is_fault, const char* text) { return is_fault ? std::string(text) : std::string(); };
  switch (requirement) {
    case Requirement::RootPositions: return fault(is_root(skeleton, joint) && positions != 3, "root without positions");
    case Requirement::PositionsOfRootOnly: return fault(!is_root(skeleton, joint) && positions > 0, "positions");
    case Requirement::WholePositions: return fault(positions != 0 && positions != 3, "part of positions");
    case Requirement::NoRootOffset:
      return fault(is_root(skeleton, joint) && skeleton.offset(joint) != glm::dvec3(0.0), "root offset");
    case Requirement::ThreeRotations: return fault(!has_three_axes(order), "rotations");
    case Requirement::ThreeRotationsOrNone: return fault(!order.empty() && !has_three_axes(order), "rotations");
    case Requirement::RotationOrderZxy: return fault(order != "ZXY", "order");
    case Requirement::AsciiNames: return fault(!has_word_letters(skeleton.name(joint), "_-.:"), "name");
    case Requirement::WordNames: return fault(!has_word_letters(skeleton.name(joint), "_"), "name");
    case Requirement::EndSites: return fault(is_leaf && ends == 0, "open limb");
    case Requirement::NoInnerEndSites: return fault(ends > (is_leaf ? 1 : 0), "end sites");
    default: return {};
  }
}

bool starts_with_all_angles_0(const ExportedClip& clip) {
  constexpr double kTolerance_deg = 0.01;
  for (ChannelIndex channel = 0; channel < clip.skeleton.channel_count(); ++channel) {
    if (is_rotation(clip.skeleton.channel(channel).kind) && std::abs(clip.motion.sample(channel, 0)) > kTolerance_deg) return false;
  }
  return true;
}

}  // namespace

std::string fault_of(const ExportedClip& clip, Requirement requirement) {
  const Skeleton& skeleton = clip.skeleton;
  std::set<std::string> names;
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    const std::string fault = joint_fault(skeleton, joint, requirement);
    if (!fault.empty()) return fault + " at " + skeleton.name(joint);
    names.insert(skeleton.name(joint));
  }
  const bool wants_names = requirement == Requirement::AsciiNames || requirement == Requirement::WordNames;
  if (wants_names && static_cast<int>(names.size()) != skeleton.joint_count()) return "repeated names";
  const auto roots = std::count(skeleton.parents().begin(), skeleton.parents().end(), kNoParent);
  if (requirement == Requirement::OneRoot && roots != 1) return "roots";
  if (requirement == Requirement::PositionsAddToOffset && clip.position_rule != PositionRule::Add) return "rule";
  if (requirement == Requirement::ReferencePose && !starts_with_all_angles_0(clip)) return "first frame";
  return {};
}

double largest_distance(const Clip& clip, const ExportedClip& exported) {
  LocalPose local_before, local_after;
  WorldPose before, after;
  local_before.resize(clip.skeleton);
  before.resize(clip.skeleton);
  local_after.resize(exported.skeleton);
  after.resize(exported.skeleton);
  double largest = 0.0;
  for (FrameIndex frame = 0; frame < clip.motion.frame_count(); ++frame) {
    compute_local_pose(clip.skeleton, clip.motion, frame, clip.settings.position_rule, local_before);
    compute_world_pose(clip.skeleton, local_before, before);
    compute_local_pose(exported.skeleton, exported.motion, frame + exported.added_frames, exported.position_rule, local_after);
    compute_world_pose(exported.skeleton, local_after, after);
    for (NodeIndex node = 0; node < clip.skeleton.node_count(); ++node) {
      if (exported.nodes[idx(node)] == kNoParent) continue;
      const glm::dvec3 away = before.world_positions[idx(node)] - after.world_positions[idx(exported.nodes[idx(node)])];
      largest = std::max(largest, std::hypot(away.x, away.y, away.z));
    }
  }
  return largest;
}

const ExportChange* find_change(const ExportedClip& clip, ExportChangeKind kind) {
  const auto found = std::find_if(clip.changes.begin(), clip.changes.end(),
                                  [kind](const ExportChange& change) { return change.kind == kind; });
  return found == clip.changes.end() ? nullptr : &*found;
}

std::string listing(const ExportedClip& clip) {
  std::string text;
  for (const ExportChange& change : clip.changes) {
    text.append(export_change_id(change.kind)).append(": ").append(change.message).append("\n");
  }
  return text;
}

}  // namespace marey::test
