#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/counted.h"
#include "core/editing/mirror_pairing.h"
#include "core/editing/operations/families.h"
#include "core/editing/operations/new_samples.h"
#include "core/motion/sampling.h"

namespace marey {
namespace {

using Outcome = Result<OperationOutcome>;

// 0 keeps its sign, so that no "-0" comes into the file.
double negated(double value) { return value == 0.0 ? value : -value; }

/// Mirrors joints across the plane through the world's origin whose normal is an axis: R' = M R M, so rotations about the
/// axis stay and the others change their sign, whatever their order; p' = M p. Where the rest pose is not its own mirror image,
/// R' = C_parent^-1 M R M C with the corrections of find_mirror_corrections().
class Mirror {
 public:
  Mirror(const OperationCall& call, const MirrorPairing& pairing, Axis axis)
      : call_(call),
        skeleton_(call.clip.skeleton),
        axis_(axis),
        corrections_(find_mirror_corrections(call.clip.skeleton, pairing, axis)) {}

  // New samples of a joint from those of its counterpart.
  void add(JointIndex joint, JointIndex from) {
    const bool same_order = euler_order_label(skeleton_, joint) == euler_order_label(skeleton_, from);
    const auto to_euler = find_euler_channels(skeleton_, joint);
    const bool is_plain = same_order && !needs_correction(joint);
    const bool by_rotation = !is_plain && to_euler && to_euler->count == 3;
    if (by_rotation) add_rotation(*to_euler, joint, from);
    if (!is_plain && !by_rotation) unlike_.push_back(joint);
    for (int i = 0; i < skeleton_.channel_count(joint); ++i) {
      const ChannelIndex channel = skeleton_.first_channel(joint) + i;
      const ChannelKind kind = skeleton_.channel(channel).kind;
      if (kind == ChannelKind::Other || (is_rotation(kind) && by_rotation)) continue;
      if (const auto source = find_source(from, channel)) add_channel(channel, *source);
    }
  }

  std::vector<NewSamples> take_samples() {
    std::sort(samples_.begin(), samples_.end(), [](const NewSamples& a, const NewSamples& b) { return a.channel < b.channel; });
    return std::move(samples_);
  }
  [[nodiscard]] const std::vector<JointIndex>& unlike() const { return unlike_; }

 private:
  // The channel of the same kind; where a kind repeats, the one at the same place of its kind.
  [[nodiscard]] std::optional<ChannelIndex> find_source(JointIndex from, ChannelIndex channel) const {
    const Channel& wanted = skeleton_.channel(channel);
    int before = 0;
    for (ChannelIndex c = skeleton_.first_channel(wanted.joint); c < channel; ++c) before += skeleton_.channel(c).kind == wanted.kind;
    for (int i = 0; i < skeleton_.channel_count(from); ++i) {
      const ChannelIndex candidate = skeleton_.first_channel(from) + i;
      if (skeleton_.channel(candidate).kind == wanted.kind && before-- == 0) return candidate;
    }
    return std::nullopt;
  }

  void add_channel(ChannelIndex channel, ChannelIndex source) {
    const Channel& to = skeleton_.channel(channel);
    const Channel& from = skeleton_.channel(source);
    const bool along = axis_of(to.kind) == axis_;
    const bool flips = is_rotation(to.kind) ? !along : is_position(to.kind) && along;
    const double own_offset = is_position(to.kind) ? added_offset(to) : 0.0;
    const double other_offset = is_position(to.kind) ? added_offset(from) : 0.0;
    const double shift = (flips ? -other_offset : other_offset) - own_offset;
    const std::span<const double> before = target_samples(call_, source);
    NewSamples after{channel, {before.begin(), before.end()}};
    for (double& value : after.values) {
      if (flips) value = negated(value);
      if (shift != 0.0) value += shift;
    }
    samples_.push_back(std::move(after));
  }

  // What the rule adds to a position channel.
  [[nodiscard]] double added_offset(const Channel& channel) const {
    const bool adds = skeleton_.positions_add(channel.joint, call_.clip.settings.position_rule);
    return adds ? skeleton_.offset(channel.joint)[static_cast<int>(axis_of(channel.kind))] : 0.0;
  }

  [[nodiscard]] glm::dquat correction_above(JointIndex joint) const {
    const JointIndex parent = skeleton_.parent(joint);
    return parent == kNoParent ? glm::dquat(1.0, 0.0, 0.0, 0.0) : corrections_[idx(parent)];
  }
  [[nodiscard]] bool needs_correction(JointIndex joint) const {
    return correction_above(joint).w != 1.0 || corrections_[idx(joint)].w != 1.0;
  }

  void add_rotation(const EulerChannels& to, JointIndex joint, JointIndex from) {
    std::vector<NewSamples> angles = copied_angles(call_, to);
    glm::dvec3 previous(0.0);
    for (int i = 0; i < call_.target.frames.count; ++i) {
      glm::dquat rotation = joint_rotation(skeleton_, call_.clip.motion, from, call_.target.frames.first + i);
      for (int a = 0; a < 3; ++a) rotation[a] = a == static_cast<int>(axis_) ? rotation[a] : -rotation[a];
      if (!std::isfinite(rotation.w)) continue;
      rotation = glm::normalize(glm::conjugate(correction_above(joint)) * rotation * corrections_[idx(joint)]);
      previous = euler_near(to.order, glm::mat3_cast(rotation), previous);
      set_angles(angles, idx(i), previous);
    }
    append(samples_, std::move(angles));
  }

  const OperationCall& call_;
  const Skeleton& skeleton_;
  Axis axis_;
  std::vector<glm::dquat> corrections_;  // per joint
  std::vector<NewSamples> samples_;
  std::vector<JointIndex> unlike_;
};

// "LeftArm, LeftHand and 3 more".
std::string list_names(const Skeleton& skeleton, std::span<const JointIndex> joints) {
  constexpr std::size_t kMostNames = 4;
  std::string names;
  for (std::size_t i = 0; i < std::min(joints.size(), kMostNames); ++i) {
    names += (i > 0 ? ", " : "") + skeleton.name(joints[i]);
  }
  return joints.size() > kMostNames ? fmt::format("{} and {} more", names, joints.size() - kMostNames) : names;
}

void note_joints(const OperationCall& call, std::span<const JointIndex> joints, std::string_view what,
                 std::vector<std::string>& notes) {
  if (joints.empty()) return;
  notes.push_back(fmt::format("{} {}: {}.", counted(size_of(joints), "joint"), what, list_names(call.clip.skeleton, joints)));
}

Outcome make_mirror(const OperationCall& call) {
  const Skeleton& skeleton = call.clip.skeleton;
  const MirrorPairing pairing = find_mirror_pairs(skeleton);
  const std::string_view asked = call.choice("axis");
  const Axis axis = asked == "auto" ? find_lateral_axis(skeleton, pairing, call.clip.settings.up_axis) : static_cast<Axis>(asked[0] - 'x');
  Mirror mirror(call, pairing, axis);
  for (const JointIndex joint : call.target.joints) mirror.add(joint, pairing.partner[idx(joint)]);
  OperationOutcome outcome;
  note_joints(call, pairing.unpaired, "of a side found no counterpart", outcome.notes);
  note_joints(call, find_unsymmetric_joints(skeleton, pairing, axis),
              "have offsets that are no mirror image of their counterparts', so the pose is none there", outcome.notes);
  note_joints(call, mirror.unlike(), "have not the rotation channels that this takes", outcome.notes);
  outcome.edit = blended_edit(call, mirror.take_samples(), Mix::Rotations);
  return outcome;
}

constexpr std::string_view kAxes[] = {"auto", "x", "y", "z"};
constexpr OperationParameter kMirror[] = {
    {.name = "axis", .label = "Axis", .help = "Across the body; by default the one that left and right joints lie apart on.",
     .kind = ParameterKind::Choice, .most = 3.0, .choices = kAxes}};

constexpr Operation kOperations[] = {
    {.id = "mirror", .label = "Mirror", .group = "Clip",
     .help = "Exchanges left and right, as a mirror across the body shows it.", .reach = OperationReach::Joints,
     .parameters = kMirror, .make = make_mirror}};

}  // namespace

std::span<const Operation> mirror_operations() { return kOperations; }

}  // namespace marey
