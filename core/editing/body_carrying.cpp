#include "core/editing/body_carrying.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/matrix.hpp>

#include "core/base/counted.h"
#include "core/biomechanics/body_model.h"

namespace marey {
namespace {

/// Old indices to new ones.
class Renumbering {
 public:
  Renumbering(const Skeleton& before, const Skeleton& after, std::span<const NodeIndex> origins)
      : nodes_(idx(before.node_count()), kNoParent), joints_(idx(before.joint_count()), kNoParent) {
    for (NodeIndex node = 0; node < after.node_count(); ++node) {
      const NodeIndex origin = origins[idx(node)];
      if (origin == kNoParent || before.node(origin).is_end_site != after.node(node).is_end_site) continue;
      nodes_[idx(origin)] = node;
      if (!after.node(node).is_end_site) joints_[idx(before.node(origin).joint)] = after.node(node).joint;
    }
  }
  [[nodiscard]] NodeIndex node(NodeIndex before) const { return nodes_[idx(before)]; }
  [[nodiscard]] JointIndex joint(JointIndex before) const { return joints_[idx(before)]; }

 private:
  std::vector<NodeIndex> nodes_;
  std::vector<JointIndex> joints_;
};

template <class OfJoint>
int carry_joints(std::vector<OfJoint>& list, const Renumbering& renumbering) {
  for (OfJoint& one : list) one.joint = renumbering.joint(one.joint);
  const auto lost = std::erase_if(list, [](const OfJoint& one) { return one.joint == kNoParent; });
  std::sort(list.begin(), list.end(), [](const OfJoint& a, const OfJoint& b) { return a.joint < b.joint; });
  return static_cast<int>(lost);
}

bool has_children(const Skeleton& skeleton, NodeIndex node) {
  const Node& n = skeleton.node(node);
  return !n.is_end_site && node + 1 < skeleton.node_count() && skeleton.node(node + 1).parent == node;
}

int carry_contacts(std::vector<OwnContact>& contacts, const Skeleton& after, const Renumbering& renumbering) {
  for (OwnContact& contact : contacts) contact.node = renumbering.node(contact.node);
  const auto lost = std::erase_if(contacts, [&](const OwnContact& c) { return c.node == kNoParent || has_children(after, c.node); });
  std::sort(contacts.begin(), contacts.end(), [](const OwnContact& a, const OwnContact& b) {
    return a.node != b.node ? a.node < b.node : a.first < b.first;
  });
  return static_cast<int>(lost);
}

}  // namespace

BodyChoice carry_body_over(const BodyChoice& body, const Skeleton& before, const Skeleton& after, std::span<const NodeIndex> origins,
                           std::vector<std::string>& notes) {
  const Renumbering renumbering(before, after, origins);
  BodyChoice carried = body;
  const int segments = carry_joints(carried.segments, renumbering);
  const int parts = carry_joints(carried.parts, renumbering);
  const int contacts = carry_contacts(carried.contacts, after, renumbering);
  if (segments > 0) notes.push_back(fmt::format("{} of your own went with the joints.", counted(segments, "segment")));
  if (parts > 0) notes.emplace_back("What was said that the removed joints carry is forgotten.");
  if (contacts > 0) notes.push_back(fmt::format("{} set by hand went with the points.", counted(contacts, "contact")));
  return carried;
}

void turn_own_segments(BodyChoice& body, std::span<const glm::dmat3> rotations) {
  for (OwnSegment& own : body.segments) {
    if (!own.shape) continue;
    const glm::dmat3& rotation = rotations[idx(own.joint)];
    own.shape->com_m = rotation * own.shape->com_m;
    own.shape->inertia_kgm2 = moments_of(rotation * symmetric_tensor(own.shape->inertia_kgm2) * glm::transpose(rotation));
  }
}

void scale_own_segments(BodyChoice& body, double factor) {
  for (OwnSegment& own : body.segments) {
    if (!own.shape) continue;
    own.shape->com_m *= factor;
    for (double& moment : own.shape->inertia_kgm2) moment *= factor * factor;
  }
}

}  // namespace marey
