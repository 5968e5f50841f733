#include "core/biomechanics/chain_links.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/counted.h"
#include "core/biomechanics/joint_tracks.h"
#include "core/motion/euler_channels.h"

namespace marey {
namespace {

glm::dvec3 unit_of(Axis axis) {
  glm::dvec3 unit(0.0);
  unit[static_cast<int>(axis)] = 1.0;
  return unit;
}

bool has_weight(const Segment& segment) {
  return segment.mass_kg > 0.0 || segment.inertia_kgm2[0][0] + segment.inertia_kgm2[1][1] + segment.inertia_kgm2[2][2] > 0.0;
}

/// By joint: whether anything with mass turns with it.
std::vector<bool> find_carriers(const Skeleton& skeleton, const BodyModel& model) {
  std::vector<bool> carries(idx(skeleton.joint_count()));
  for (const Segment& segment : model.segments) {
    if (has_weight(segment)) carries[idx(segment.joint)] = true;
  }
  for (JointIndex joint = skeleton.joint_count() - 1; joint >= 0; --joint) {
    if (carries[idx(joint)] && skeleton.parent(joint) != kNoParent) carries[idx(skeleton.parent(joint))] = true;
  }
  return carries;
}

/// The axis of a joint with one rotation channel.
std::optional<Axis> find_hinge_axis(const Skeleton& skeleton, JointIndex joint) {
  std::optional<Axis> axis;
  for (const Channel& channel : skeleton.channels(joint)) {
    if (!is_rotation(channel.kind)) continue;
    if (axis) return std::nullopt;
    axis = axis_of(channel.kind);
  }
  return axis;
}

/// A turn about one axis and then about another, which stands across it, as these two. Not by Euler's angles: beyond a right
/// angle of the second those have a third.
std::pair<glm::dquat, glm::dquat> split_turn(const glm::dquat& rotation, const glm::dvec3& axis, const glm::dvec3& next) {
  const glm::dvec3 across = glm::cross(axis, next);
  const glm::dvec3 there = rotation * next;
  const glm::dvec3 back = glm::conjugate(rotation) * axis;
  return {glm::angleAxis(std::atan2(glm::dot(across, there), glm::dot(next, there)), axis),
          glm::angleAxis(std::atan2(glm::dot(across, back), glm::dot(axis, back)), next)};
}

class LinkBuilder {
 public:
  LinkBuilder(const Skeleton& skeleton, const ChainState& state)
      : skeleton_(skeleton), state_(state), last_links_(idx(skeleton.joint_count()), kNoParent) {}

  /// Joints come in their order; one that carries nothing has no link.
  void add_joint(JointIndex joint, bool carries, bool slides);
  void add_mass(const Segment& segment);
  [[nodiscard]] ChainLinks take();

 private:
  void add_turns(JointIndex joint);
  void add(LinkKind kind, const glm::dvec3& axis, const glm::dquat& rotation, const glm::dvec3& speed);

  const Skeleton& skeleton_;
  const ChainState& state_;
  std::vector<int> last_links_;  // by joint
  ChainLinks made_;
  int parent_ = kNoParent;   // of the next link
  glm::dvec3 offset_{0.0};
};

void LinkBuilder::add(LinkKind kind, const glm::dvec3& axis, const glm::dquat& rotation, const glm::dvec3& speed) {
  Link link;
  link.parent = parent_;
  link.kind = kind;
  link.axis = axis;
  link.offset = offset_;
  made_.links.push_back(link);
  made_.states.push_back({rotation, glm::dvec3(0.0), speed});
  parent_ = size_of(made_.links) - 1;
  offset_ = glm::dvec3(0.0);
}

void LinkBuilder::add_joint(JointIndex joint, bool carries, bool slides) {
  made_.first_links.push_back(size_of(made_.links));
  if (!carries) return;
  const JointIndex parent = skeleton_.parent(joint);
  parent_ = parent == kNoParent ? kNoParent : last_links_[idx(parent)];
  offset_ = state_.positions[idx(joint)];
  if (slides) add(LinkKind::Slide, glm::dvec3(0.0), {1.0, 0.0, 0.0, 0.0}, state_.velocities[idx(joint)]);
  add_turns(joint);
  last_links_[idx(joint)] = parent_;
}

void LinkBuilder::add_turns(JointIndex joint) {
  const glm::dquat& rotation = state_.rotations[idx(joint)];
  const glm::dvec3& turning = state_.angular_velocities[idx(joint)];
  const auto euler = find_euler_channels(skeleton_, joint);
  if (euler && euler->count == 3) return add(LinkKind::Ball, glm::dvec3(0.0), rotation, glm::conjugate(rotation) * turning);
  if (euler) {
    const glm::dvec3 axis = unit_of(euler->order.first);
    const glm::dvec3 next = unit_of(euler->order.second);
    const auto [first, second] = split_turn(rotation, axis, next);
    add(LinkKind::Hinge, axis, first, axis * glm::dot(axis, turning));
    return add(LinkKind::Hinge, next, second, next * glm::dot(first * next, turning));
  }
  const std::optional<Axis> hinge = find_hinge_axis(skeleton_, joint);
  const glm::dvec3 axis = hinge ? unit_of(*hinge) : glm::dvec3(0.0);
  add(hinge ? LinkKind::Hinge : LinkKind::Fixed, axis, rotation, axis * glm::dot(axis, turning));
}

void LinkBuilder::add_mass(const Segment& segment) {
  if (last_links_[idx(segment.joint)] == kNoParent) return;
  Link& link = made_.links[idx(last_links_[idx(segment.joint)])];
  const glm::dvec3& c = segment.com_m;
  link.mass += segment.mass_kg;
  link.moment += segment.mass_kg * c;
  link.inertia += segment.inertia_kgm2 + segment.mass_kg * (glm::dot(c, c) * glm::dmat3(1.0) - glm::outerProduct(c, c));
}

ChainLinks LinkBuilder::take() {
  made_.first_links.push_back(size_of(made_.links));
  return std::move(made_);
}

/// The frames that the differences at one frame need; `frame` becomes its place among them.
FrameRange frames_around(int frame_count, FrameIndex& frame) {
  const int count = std::min(frame_count, 4);
  const FrameIndex first = std::clamp(frame - 1, 0, frame_count - count);
  frame -= first;
  return {first, count};
}

Status check_samples(const Clip& clip, FrameRange frames) {
  for (ChannelIndex channel = 0; channel < clip.motion.channel_count(); ++channel) {
    const ChannelKind kind = clip.skeleton.channel(channel).kind;
    if (!is_rotation(kind) && !is_position(kind)) continue;
    for (FrameIndex frame = frames.first; frame < frames.end(); ++frame) {
      if (std::isfinite(clip.motion.sample(channel, frame))) continue;
      return Error{DiagnosticCode::NotFinite, {},
                   fmt::format("{} of frame {} is not a finite number; let go at another frame, or fill the gaps.",
                               channel_label(clip.skeleton, channel), frame + 1), {}, {}};
    }
  }
  return {};
}

}  // namespace

Result<ChainState> find_chain_state(const Clip& clip, FrameIndex frame, bool is_moving) {
  const int frame_count = clip.motion.frame_count();
  if (frame < 0 || frame >= frame_count) {
    return Error{DiagnosticCode::InvalidArgument, {},
                 fmt::format("The clip has {}; there is no frame {} to let go at.", counted(frame_count, "frame"), frame + 1), {}, {}};
  }
  const FrameRange frames = is_moving ? frames_around(frame_count, frame) : FrameRange{std::exchange(frame, 0), 1};
  if (Status status = check_samples(clip, frames); !status) return status.error();
  Clip part;
  part.skeleton = clip.skeleton;
  part.motion = clip.motion.frames_of(frames);
  part.settings = clip.settings;
  const auto tracks = find_joint_tracks(part, {}, clip.motion.frame_time_s(), clip.settings.metres_per_unit);
  if (!tracks) return tracks.error();
  ChainState state;
  for (const JointTrack& track : *tracks) {
    state.rotations.push_back(track.rotations[idx(frame)]);
    state.angular_velocities.push_back(track.angular_velocities[idx(frame)]);
    state.positions.push_back(track.origin.positions[idx(frame)]);
    state.velocities.push_back(track.origin.velocities[idx(frame)]);
  }
  return state;
}

ChainLinks make_chain_links(const Skeleton& skeleton, const BodyModel& model, const ChainState& state, bool root_held) {
  const std::vector<bool> carries = find_carriers(skeleton, model);
  LinkBuilder builder(skeleton, state);
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    builder.add_joint(joint, carries[idx(joint)], !root_held && skeleton.parent(joint) == kNoParent);
  }
  for (const Segment& segment : model.segments) builder.add_mass(segment);
  return builder.take();
}

}  // namespace marey
