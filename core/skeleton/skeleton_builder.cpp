#include "core/skeleton/skeleton_builder.h"

#include <cmath>
#include <utility>

namespace marey {
namespace {

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

JointIndex SkeletonBuilder::open_joint(std::string name_bytes, const glm::dvec3& offset_file_units) {
  const JointIndex joint = skeleton_.joint_count();
  const JointIndex parent = current_joint();
  const NodeIndex parent_node = parent == kNoParent ? kNoParent : skeleton_.node_of(parent);
  skeleton_.joint_nodes_.push_back(skeleton_.node_count());
  skeleton_.nodes_.push_back({joint, parent_node, false, offset_file_units, {}, std::move(name_bytes)});
  skeleton_.parents_.push_back(parent);
  skeleton_.first_channels_.push_back(skeleton_.channel_count());
  skeleton_.subtree_ends_.push_back(joint + 1);
  skeleton_.depths_.push_back(open_depth());
  open_.push_back(joint);
  return joint;
}

void SkeletonBuilder::add_channel(ChannelKind kind, std::string other_name) {
  if (open_.empty()) {
    defect_ = "A channel stands outside of a joint.";
    return;
  }
  if (current_joint() + 1 != skeleton_.joint_count()) {
    defect_ = "The channels of '" + skeleton_.nodes_[idx(skeleton_.node_of(current_joint()))].name_bytes + "' stand behind its first child.";
    return;
  }
  skeleton_.channels_.push_back({current_joint(), kind, std::move(other_name)});
  skeleton_.first_channels_.back() = skeleton_.channel_count();
}

NodeIndex SkeletonBuilder::add_end_site(const glm::dvec3& offset_file_units, std::string name_bytes) {
  if (open_.empty()) {
    defect_ = "An end site stands outside of a joint.";
    return kNoParent;
  }
  const NodeIndex node = skeleton_.node_count();
  skeleton_.nodes_.push_back(
      {current_joint(), skeleton_.node_of(current_joint()), true, offset_file_units, {}, std::move(name_bytes)});
  return node;
}

void SkeletonBuilder::close_joint() {
  if (open_.empty()) {
    defect_ = "More joints are closed than were opened.";
    return;
  }
  skeleton_.subtree_ends_[idx(open_.back())] = skeleton_.joint_count();
  open_.pop_back();
}

void SkeletonBuilder::set_offset(NodeIndex node, const glm::dvec3& offset_file_units) {
  skeleton_.set_offset(node, offset_file_units);
}

Result<Skeleton> SkeletonBuilder::build() {
  Skeleton skeleton = std::exchange(skeleton_, Skeleton());
  const bool all_closed = std::exchange(open_, {}).empty();
  std::string defect = std::exchange(defect_, {});
  if (defect.empty() && skeleton.joint_count() == 0) defect = "A skeleton needs at least one joint.";
  if (defect.empty() && !all_closed) defect = "A joint was opened but never closed.";
  for (const Node& node : skeleton.nodes()) {
    if (defect.empty() && !is_finite(node.offset)) defect = "The offset of '" + node.name_bytes + "' is not a finite number.";
  }
  if (!defect.empty()) return Error{DiagnosticCode::InvalidSkeleton, {}, std::move(defect), {}, {}};
  skeleton.read_names_in(CharacterSet::Utf8);
  return skeleton;
}

}  // namespace marey
