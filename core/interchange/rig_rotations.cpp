#include "core/interchange/rig_rotations.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <string_view>
#include <utility>

#include "core/base/counted.h"

namespace marey {
namespace {

constexpr EulerOrder kUsualOrder{Axis::Z, Axis::X, Axis::Y};

std::array<Axis, 3> axes_of(EulerOrder order) { return {order.first, order.second, order.third}; }

bool has_three_axes(const std::vector<Axis>& axes) {
  return axes.size() == 3 && axes[0] != axes[1] && axes[1] != axes[2] && axes[0] != axes[2];
}

/// True if the joint's rotations are some of those of `order`, one after the other.
bool fits(const std::vector<Axis>& axes, EulerOrder order) {
  std::size_t next = 0;
  for (const Axis axis : axes_of(order)) {
    if (next < axes.size() && axes[next] == axis) ++next;
  }
  return next == axes.size();
}

/// The most frequent order of joints with three different axes.
EulerOrder most_used_order(const Rig& rig) {
  std::vector<std::pair<EulerOrder, int>> uses;
  for (const RigJoint& joint : rig.joints) {
    if (!has_three_axes(joint.axes)) continue;
    const EulerOrder order{joint.axes[0], joint.axes[1], joint.axes[2]};
    const auto use = std::find_if(uses.begin(), uses.end(), [order](const auto& u) { return u.first == order; });
    if (use == uses.end()) {
      uses.emplace_back(order, 1);
    } else {
      ++use->second;
    }
  }
  const auto most = std::max_element(uses.begin(), uses.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == uses.end() ? kUsualOrder : most->first;
}

/// An order that the joint's rotations fit, the preferred one if they do; that too where they fit none.
EulerOrder order_for(const std::vector<Axis>& axes, EulerOrder preferred) {
  if (fits(axes, preferred)) return preferred;
  if (axes.size() == 2 && axes[0] != axes[1]) {
    return {axes[0], axes[1], static_cast<Axis>(3 - static_cast<int>(axes[0]) - static_cast<int>(axes[1]))};
  }
  return preferred;
}

void insert_zero_curves(RigJoint& joint, EulerOrder order, int frame_count) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Axis axis = axes_of(order)[i];
    if (i < joint.axes.size() && joint.axes[i] == axis) continue;
    joint.axes.insert(joint.axes.begin() + static_cast<std::ptrdiff_t>(i), axis);
    joint.angles_deg.insert(joint.angles_deg.begin() + static_cast<std::ptrdiff_t>(i),
                            RigJoint::Curve(idx(frame_count), 0.0));
  }
}

/// Computed angles carry rounding errors in their last digits, which would only make the file longer.
double without_noise(double angle_deg) {
  constexpr double kSteps = 1e11;
  constexpr double kLargest = 8192.0;  // beyond, a double has no such steps
  const double rounded = std::round(angle_deg * kSteps) / kSteps;
  return std::abs(angle_deg) < kLargest ? rounded + 0.0 : angle_deg;
}

/// In the first frame the angles nearest to the joint's own, so that whole turns stay; then the nearest to the frame
/// before, so that the curves go on without leaps.
void solve(RigJoint& joint, EulerOrder order, int frame_count) {
  std::vector<RigJoint::Curve> solved(3, RigJoint::Curve(idx(frame_count)));
  std::vector<double> own(joint.axes.size());
  glm::dvec3 nearest_deg(0.0);
  for (FrameIndex frame = 0; frame < frame_count; ++frame) {
    for (std::size_t i = 0; i < own.size(); ++i) {
      own[i] = joint.angles_deg[i][idx(frame)];
      if (frame > 0) continue;
      for (int k = 0; k < 3; ++k) nearest_deg[k] += axes_of(order)[idx(k)] == joint.axes[i] ? own[i] : 0.0;
    }
    const glm::dmat3 rotation = glm::mat3_cast(glm::normalize(rotation_from_euler(joint.axes, own)));
    nearest_deg = euler_near(order, rotation, nearest_deg);
    for (int k = 0; k < 3; ++k) solved[idx(k)][idx(frame)] = without_noise(nearest_deg[k]);
  }
  const std::array<Axis, 3> axes = axes_of(order);
  joint.axes.assign(axes.begin(), axes.end());
  joint.angles_deg = std::move(solved);
}

struct Rewritten {
  std::vector<JointIndex> extended;
  std::vector<JointIndex> solved;
};

void rewrite(Rig& rig, JointIndex joint, EulerOrder order, Rewritten& done) {
  RigJoint& part = rig.joints[idx(joint)];
  if (!fits(part.axes, order)) {
    solve(part, order, rig.frame_count);
    done.solved.push_back(joint);
  } else if (part.axes.size() < 3) {
    insert_zero_curves(part, order, rig.frame_count);
    done.extended.push_back(joint);
  }
}

void report(const Rig& rig, const Rewritten& done, std::string_view order, ExportChanges& changes) {
  const auto joints = [](const std::vector<JointIndex>& list, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", counted(size_of(list), "joint"), list.size() == 1 ? one : many);
  };
  if (!done.extended.empty()) {
    changes.push_back({ExportChangeKind::RotationsAdded, false, size_of(done.extended),
                       fmt::format("{} rotations that stay 0: {}.", joints(done.extended, "gets", "get"),
                                   listed_joints(rig, done.extended))});
  }
  if (!done.solved.empty()) {
    changes.push_back({ExportChangeKind::RotationsSolved, false, size_of(done.solved),
                       fmt::format("{} other angles {}for the same rotations: {}.", joints(done.solved, "gets", "get"),
                                   order, listed_joints(rig, done.solved))});
  }
}

}  // namespace

void give_three_rotations(Rig& rig, bool only_rotating, ExportChanges& changes) {
  const EulerOrder preferred = most_used_order(rig);
  Rewritten done;
  for (JointIndex joint = 0; joint < size_of(rig.joints); ++joint) {
    const std::vector<Axis>& axes = rig.joints[idx(joint)].axes;
    if (has_three_axes(axes) || (only_rotating && axes.empty())) continue;
    rewrite(rig, joint, order_for(axes, preferred), done);
  }
  report(rig, done, "", changes);
}

void give_one_order(Rig& rig, EulerOrder order, ExportChanges& changes) {
  Rewritten done;
  for (JointIndex joint = 0; joint < size_of(rig.joints); ++joint) rewrite(rig, joint, order, done);
  report(rig, done, "in the one order ", changes);
}

}  // namespace marey
