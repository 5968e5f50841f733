#include "core/interchange/rig_ends.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/counted.h"

namespace marey {

void drop_end_site_names(Rig& rig, ExportChanges& changes) {
  int named = 0;
  for (RigJoint& joint : rig.joints) {
    for (RigEnd& end : joint.end_sites) {
      named += end.name.empty() ? 0 : 1;
      end.name.clear();
    }
  }
  if (named == 0) return;
  changes.push_back({ExportChangeKind::EndSiteNamesDropped, true, named,
                     fmt::format("{} {}.", counted(named, "End Site"), named == 1 ? "loses its name" : "lose their names")});
}

void drop_inner_end_sites(Rig& rig, ExportChanges& changes) {
  const std::vector<bool> with_children = rig.with_children();
  std::vector<JointIndex> joints;
  int dropped = 0;
  for (JointIndex joint = 0; joint < size_of(rig.joints); ++joint) {
    std::vector<RigEnd>& ends = rig.joints[idx(joint)].end_sites;
    const std::size_t kept = with_children[idx(joint)] ? 0 : 1;
    if (ends.size() <= kept) continue;
    dropped += size_of(ends) - static_cast<int>(kept);
    ends.resize(kept);
    joints.push_back(joint);
  }
  if (dropped == 0) return;
  changes.push_back({ExportChangeKind::EndSitesDropped, true, dropped,
                     fmt::format("{} beside children or beside another one {} left out, at {}.",
                                 counted(dropped, "End Site"), dropped == 1 ? "is" : "are", listed_joints(rig, joints))});
}

void close_limbs(Rig& rig, ExportChanges& changes) {
  const std::vector<bool> with_children = rig.with_children();
  std::vector<JointIndex> closed;
  for (JointIndex joint = 0; joint < size_of(rig.joints); ++joint) {
    RigJoint& part = rig.joints[idx(joint)];
    if (!part.end_sites.empty() || with_children[idx(joint)]) continue;
    const bool has_bone = part.parent != kNoParent && part.offset != glm::dvec3(0.0);
    part.end_sites.push_back({has_bone ? part.offset * 0.25 : glm::dvec3(0.0, 1.0, 0.0), {}, kNoParent});
    closed.push_back(joint);
  }
  if (closed.empty()) return;
  changes.push_back({ExportChangeKind::EndSitesAdded, false, size_of(closed),
                     fmt::format("{} an End Site that goes on from the last bone: {}.",
                                 counted(size_of(closed), "limb") + (closed.size() == 1 ? " gets" : " get"),
                                 listed_joints(rig, closed))});
}

void note_bones_without_length(const Rig& rig, ExportChanges& changes) {
  std::vector<JointIndex> joints;
  for (JointIndex joint = 0; joint < size_of(rig.joints); ++joint) {
    const RigJoint& part = rig.joints[idx(joint)];
    const bool has_point = std::any_of(part.end_sites.begin(), part.end_sites.end(),
                                       [](const RigEnd& end) { return end.offset == glm::dvec3(0.0); });
    const bool is_point = part.parent != kNoParent && part.offset == glm::dvec3(0.0);
    if (has_point || is_point) joints.push_back(joint);
  }
  if (joints.empty()) return;
  changes.push_back({ExportChangeKind::BonesWithoutLength, false, size_of(joints),
                     fmt::format("Bones without length are kept, which some programs show longer or refuse: {}.",
                                 listed_joints(rig, joints))});
}

}  // namespace marey
