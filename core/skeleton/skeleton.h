#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/index.h"
#include "core/skeleton/channel.h"
#include "core/skeleton/position_rule.h"
#include "core/text/character_set.h"

namespace marey {

/// One column of a frame: whose it is and what it drives.
struct Channel {
  JointIndex joint = 0;
  ChannelKind kind = ChannelKind::Other;
  std::string other_name;  ///< the keyword as written, only for ChannelKind::Other
  friend bool operator==(const Channel&, const Channel&) = default;
};

/// A point whose world position is computed: a joint, or an end site of a joint.
struct Node {
  JointIndex joint = 0;         ///< the joint itself, or the joint that the end site belongs to
  NodeIndex parent = kNoParent;  ///< node of the parent joint; for an end site the node of `joint`
  bool is_end_site = false;
  glm::dvec3 offset{0.0};  ///< OFFSET in file units, from `parent`
  std::string name;        ///< joint name, valid UTF-8; for an end site the name behind "End Site", mostly empty
  std::string name_bytes;  ///< the same as it stands in the file, with blanks at its end
  bool positions_add = false;  ///< of a joint: see Skeleton::positions_add
  friend bool operator==(const Node&, const Node&) = default;
};

/// The tree of a figure in its rest pose: flat arrays in file order, which is depth first, so a parent stands before
/// its children and a subtree is contiguous. Made and checked only by SkeletonBuilder; immutable but for the named
/// setters, which cannot break the order.
/// Names are kept as the bytes of the file; people and programs see them as UTF-8, decoded here and nowhere else. They
/// may repeat: a joint is identified by its index.
class Skeleton {
 public:
  [[nodiscard]] int joint_count() const { return size_of(joint_nodes_); }
  [[nodiscard]] int node_count() const { return size_of(nodes_); }
  [[nodiscard]] int channel_count() const { return size_of(channels_); }

  [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }
  [[nodiscard]] const Node& node(NodeIndex node) const { return nodes_[idx(node)]; }
  [[nodiscard]] std::span<const Channel> channels() const { return channels_; }
  [[nodiscard]] const Channel& channel(ChannelIndex channel) const { return channels_[idx(channel)]; }

  /// Node of a joint.
  [[nodiscard]] NodeIndex node_of(JointIndex joint) const { return joint_nodes_[idx(joint)]; }
  /// Parent joint of each joint, kNoParent for roots; parents()[j] < j.
  [[nodiscard]] std::span<const JointIndex> parents() const { return parents_; }
  [[nodiscard]] JointIndex parent(JointIndex joint) const { return parents_[idx(joint)]; }
  [[nodiscard]] const std::string& name(JointIndex joint) const { return nodes_[idx(node_of(joint))].name; }
  [[nodiscard]] const glm::dvec3& offset(JointIndex joint) const { return nodes_[idx(node_of(joint))].offset; }

  /// The channels of a joint are the contiguous columns [first_channel, first_channel + channel_count(joint)).
  [[nodiscard]] ChannelIndex first_channel(JointIndex joint) const { return first_channels_[idx(joint)]; }
  [[nodiscard]] int channel_count(JointIndex joint) const {
    return first_channels_[idx(joint) + 1] - first_channels_[idx(joint)];
  }
  [[nodiscard]] std::span<const Channel> channels(JointIndex joint) const {
    return channels().subspan(idx(first_channel(joint)), idx(channel_count(joint)));
  }

  /// One past the last joint of the subtree of `joint`; the subtree is [joint, subtree_end(joint)).
  [[nodiscard]] JointIndex subtree_end(JointIndex joint) const { return subtree_ends_[idx(joint)]; }
  /// Number of joints above `joint`; 0 for a root.
  [[nodiscard]] int depth(JointIndex joint) const { return depths_[idx(joint)]; }

  /// Moves a joint or end site in the rest pose. Finite values only.
  void set_offset(NodeIndex node, const glm::dvec3& offset_file_units) { nodes_[idx(node)].offset = offset_file_units; }

  /// Whether PositionRule::PerJoint has the position channels of a joint add to its OFFSET.
  [[nodiscard]] bool positions_add(JointIndex joint) const { return nodes_[idx(node_of(joint))].positions_add; }
  void set_positions_add(JointIndex joint, bool add) { nodes_[idx(node_of(joint))].positions_add = add; }
  /// What `rule` comes to for a joint: whether its position channels add to its OFFSET; else they replace it.
  [[nodiscard]] bool positions_add(JointIndex joint, PositionRule rule) const {
    return rule == PositionRule::Add || (rule == PositionRule::PerJoint && positions_add(joint));
  }

  /// Reads the bytes of all names in another character set.
  void read_names_in(CharacterSet set);

  friend bool operator==(const Skeleton&, const Skeleton&) = default;

 private:
  friend class SkeletonBuilder;

  std::vector<Node> nodes_;
  std::vector<Channel> channels_;
  std::vector<NodeIndex> joint_nodes_;
  std::vector<JointIndex> parents_;
  std::vector<ChannelIndex> first_channels_{0};  // joint_count + 1 entries
  std::vector<JointIndex> subtree_ends_;
  std::vector<int> depths_;
};

/// The bytes of all names, in the order of the nodes; valid as long as the skeleton.
[[nodiscard]] std::vector<std::string_view> name_bytes_of(const Skeleton& skeleton);

/// At most `most` names that are not plain ASCII, as they read in `set`: what a person needs to choose one.
[[nodiscard]] std::vector<std::string> telling_names(const Skeleton& skeleton, CharacterSet set, int most);

/// Whether PositionRule::PerJoint differs from PositionRule::Replace.
[[nodiscard]] bool has_joints_that_add(const Skeleton& skeleton);

/// Readable name of a node: the joint's name; for an end site "<joint>_end" (then "_end2" ... for further ones).
[[nodiscard]] std::string node_label(const Skeleton& skeleton, NodeIndex node);

/// The keyword, or the name that Marey does not know.
[[nodiscard]] std::string_view channel_name(const Channel& channel);

/// "LeftElbow Zrotation": joint name and channel keyword.
[[nodiscard]] std::string channel_label(const Skeleton& skeleton, ChannelIndex channel);

/// The rotation channels of a joint in file order as letters, e.g. "ZXY", "Z", "".
[[nodiscard]] std::string euler_order_label(const Skeleton& skeleton, JointIndex joint);

/// Height of the figure in file units: the largest extent of the rest pose over the three axes, end sites included.
/// 0 for a figure without extent.
[[nodiscard]] double compute_stature(const Skeleton& skeleton);

}  // namespace marey
