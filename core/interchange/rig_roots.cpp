#include "core/interchange/rig_roots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/counted.h"
#include "core/lint/wording.h"

namespace marey {
namespace {

/// Fills the axes without a channel; true if there were any.
bool complete(RigJoint& joint, int frame_count) {
  bool is_changed = false;
  for (int axis = 0; axis < 3; ++axis) {
    if (!joint.positions[idx(axis)].empty()) continue;
    joint.positions[idx(axis)].assign(idx(frame_count), joint.offset[axis]);
    is_changed = true;
  }
  return is_changed;
}

void report_added(const Rig& rig, const std::vector<JointIndex>& joints, ExportChanges& changes) {
  if (joints.empty()) return;
  changes.push_back({ExportChangeKind::PositionsAdded, false, size_of(joints),
                     fmt::format("{} position channels that stay at OFFSET: {}.",
                                 counted(size_of(joints), "joint") + (joints.size() == 1 ? " gets" : " get"),
                                 listed_joints(rig, joints))});
}

double median_of(RigJoint::Curve samples) {
  const auto middle = samples.begin() + static_cast<std::ptrdiff_t>((samples.size() - 1) / 2);
  std::nth_element(samples.begin(), middle, samples.end());
  return *middle;
}

/// Greatest distance of the positions from OFFSET.
double largest_departure(const RigJoint& joint, int frame_count) {
  double largest = 0.0;
  for (FrameIndex frame = 0; frame < frame_count; ++frame) {
    const glm::dvec3 away = joint.place(frame) - joint.offset;
    largest = std::max(largest, std::hypot(away.x, away.y, away.z));
  }
  return largest;
}

void carry_first_root(Rig& rig, RigJoint& added) {
  std::array<RigJoint::Curve, 3> way;
  RigJoint& first = rig.joints.front();
  complete(first, rig.frame_count);
  way = first.positions;
  for (RigJoint& root : rig.joints) {
    if (root.parent != kNoParent) continue;
    complete(root, rig.frame_count);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < way[axis].size(); ++i) root.positions[axis][i] -= way[axis][i];
    }
  }
  added.positions = std::move(way);
}

}  // namespace

void join_roots(Rig& rig, bool positions_of_root_only, ExportChanges& changes) {
  const auto roots = std::count_if(rig.joints.begin(), rig.joints.end(),
                                   [](const RigJoint& joint) { return joint.parent == kNoParent; });
  if (roots < 2) return;
  RigJoint added;
  added.name = "Root";
  added.axes = {Axis::Z, Axis::X, Axis::Y};
  added.angles_deg.assign(3, RigJoint::Curve(idx(rig.frame_count), 0.0));
  if (positions_of_root_only) {
    carry_first_root(rig, added);
  } else {
    complete(added, rig.frame_count);
  }
  for (RigJoint& joint : rig.joints) ++joint.parent;  // kNoParent becomes the added root, 0
  rig.joints.insert(rig.joints.begin(), std::move(added));
  changes.push_back({ExportChangeKind::RootAdded, false, static_cast<int>(roots),
                     fmt::format("{} roots are put below an added root called 'Root'{}.", roots,
                                 positions_of_root_only ? ", which goes where the first one goes" : "")});
}

void complete_root_positions(Rig& rig, ExportChanges& changes) {
  std::vector<JointIndex> completed;
  for (JointIndex joint = 0; joint < size_of(rig.joints); ++joint) {
    RigJoint& part = rig.joints[idx(joint)];
    if (part.parent == kNoParent && complete(part, rig.frame_count)) completed.push_back(joint);
  }
  report_added(rig, completed, changes);
}

void complete_positions(Rig& rig, ExportChanges& changes) {
  std::vector<JointIndex> completed;
  for (JointIndex joint = 0; joint < size_of(rig.joints); ++joint) {
    RigJoint& part = rig.joints[idx(joint)];
    if (part.has_positions() && complete(part, rig.frame_count)) completed.push_back(joint);
  }
  report_added(rig, completed, changes);
}

void drop_positions_below_root(Rig& rig, ExportChanges& changes) {
  int idle = 0;
  double largest = 0.0;
  std::vector<JointIndex> moving;
  for (JointIndex joint = 0; joint < size_of(rig.joints); ++joint) {
    RigJoint& part = rig.joints[idx(joint)];
    if (part.parent == kNoParent || !part.has_positions()) continue;
    for (int axis = 0; axis < 3; ++axis) {
      if (!part.positions[idx(axis)].empty()) part.offset[axis] = median_of(part.positions[idx(axis)]);
    }
    const double departure = largest_departure(part, rig.frame_count);
    part.positions = {};
    if (departure > 0.0) moving.push_back(joint);
    idle += departure > 0.0 ? 0 : 1;
    largest = std::max(largest, departure);
  }
  if (idle > 0) {
    changes.push_back({ExportChangeKind::PositionsDropped, false, idle,
                       fmt::format("{} position channels that never change; OFFSET says the same.",
                                   counted(idle, "joint") + (idle == 1 ? " loses" : " lose"))});
  }
  if (moving.empty()) return;
  changes.push_back({ExportChangeKind::PositionsDropped, true, size_of(moving),
                     fmt::format("{} position channels; bones that changed by up to {} units keep one length: {}.",
                                 counted(size_of(moving), "joint") + (moving.size() == 1 ? " loses its" : " lose their"),
                                 lint::rounded(largest), listed_joints(rig, moving))});
}

void move_root_offset(Rig& rig, ExportChanges& changes) {
  int moved = 0;
  for (RigJoint& root : rig.joints) {
    if (root.parent != kNoParent || root.offset == glm::dvec3(0.0)) continue;
    complete(root, rig.frame_count);
    root.offset = glm::dvec3(0.0);
    ++moved;
  }
  if (moved == 0) return;
  changes.push_back({ExportChangeKind::RootOffsetMoved, false, moved,
                     fmt::format("The OFFSET of {} becomes 0 0 0; the positions hold the whole place.",
                                 moved == 1 ? "the root" : counted(moved, "root"))});
}

}  // namespace marey
