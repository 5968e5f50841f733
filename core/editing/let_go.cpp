#include "core/editing/let_go.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/biomechanics/chosen_body.h"
#include "core/biomechanics/support.h"
#include "core/math/angle.h"
#include "core/math/euler.h"
#include "core/motion/euler_channels.h"
#include "core/motion/resampling.h"

namespace marey {
namespace {

constexpr double kMostFrames = 200'000.0;

Error refusal(std::string message) { return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; }

/// Per axis the last position channel of a joint, as kinematics takes it.
std::array<std::optional<ChannelIndex>, 3> find_position_channels(const Skeleton& skeleton, JointIndex joint) {
  std::array<std::optional<ChannelIndex>, 3> found{};
  for (int i = 0; i < skeleton.channel_count(joint); ++i) {
    const ChannelIndex channel = skeleton.first_channel(joint) + i;
    const ChannelKind kind = skeleton.channel(channel).kind;
    if (is_position(kind)) found[static_cast<std::size_t>(axis_of(kind))] = channel;
  }
  return found;
}

Status check_can_fall(const Skeleton& skeleton) {
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    if (skeleton.parent(joint) != kNoParent) continue;
    const auto channels = find_position_channels(skeleton, joint);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (channels[axis]) continue;
      return refusal(fmt::format("'{}' has no {}position channel to fall by; hold it by root=held.", skeleton.name(joint),
                                 "XYZ"[axis]));
    }
  }
  return {};
}

/// Puts a passive motion into frames that begin as copies of the one before.
class FrameWriter {
 public:
  FrameWriter(const Clip& clip, FrameIndex start, const PassiveMotion& passive)
      : clip_(clip), start_(start), passive_(passive),
        frames_(clip.motion.channel_count(), passive.frame_count(), clip.motion.frame_time_s()) {
    for (ChannelIndex channel = 0; channel < frames_.channel_count(); ++channel) {
      const std::span<double> samples = frames_.channel_samples(channel);
      std::fill(samples.begin(), samples.end(), clip.motion.sample(channel, start));
    }
  }

  void turn(JointIndex joint, glm::dquat rotation);
  void place_roots(const ChainState& state);
  [[nodiscard]] Motion take() { return std::move(frames_); }

 private:
  void set_angles(JointIndex joint, FrameIndex frame, const glm::dmat3& rotation);

  const Clip& clip_;
  FrameIndex start_;
  const PassiveMotion& passive_;
  Motion frames_;
};

// The angles nearest to those of the frame before.
void FrameWriter::set_angles(JointIndex joint, FrameIndex frame, const glm::dmat3& rotation) {
  const Motion& before = frame == 0 ? clip_.motion : frames_;
  const FrameIndex last = frame == 0 ? start_ : frame - 1;
  if (const auto euler = find_euler_channels(clip_.skeleton, joint)) {
    const glm::dvec3 angles_deg = euler_near(euler->order, rotation, angles_deg_of(before, *euler, last));
    for (int i = 0; i < euler->count; ++i) frames_.channel_samples(euler->channels[i])[idx(frame)] = angles_deg[i];
    return;
  }
  for (int i = 0; i < clip_.skeleton.channel_count(joint); ++i) {
    const ChannelIndex channel = clip_.skeleton.first_channel(joint) + i;
    const ChannelKind kind = clip_.skeleton.channel(channel).kind;
    if (!is_rotation(kind)) continue;
    const double angle_deg = hinge_angle_from_rotation(axis_of(kind), rotation);
    frames_.channel_samples(channel)[idx(frame)] = nearest_turn(angle_deg, before.sample(channel, last));
  }
}

// A joint that does not turn keeps its samples to the bit.
void FrameWriter::turn(JointIndex joint, glm::dquat rotation) {
  const std::size_t joints = idx(passive_.joint_count);
  bool turns = false;
  for (FrameIndex frame = 0; frame < frames_.frame_count(); ++frame) {
    const glm::dquat& next = passive_.rotations[idx(frame) * joints + idx(joint)];
    turns = turns || next != rotation;
    if (turns) set_angles(joint, frame, glm::mat3_cast(next));
  }
}

void FrameWriter::place_roots(const ChainState& state) {
  const std::size_t roots = passive_.roots.size();
  for (std::size_t root = 0; root < roots; ++root) {
    const JointIndex joint = passive_.roots[root];
    const auto channels = find_position_channels(clip_.skeleton, joint);
    for (int axis = 0; axis < 3; ++axis) {
      const std::span<double> samples = frames_.channel_samples(*channels[idx(axis)]);
      for (std::size_t frame = 0; frame < samples.size(); ++frame) {
        const double way_m = passive_.root_positions[frame * roots + root][axis] - state.positions[idx(joint)][axis];
        samples[frame] += way_m / clip_.settings.metres_per_unit;
      }
    }
  }
}

Result<int> find_frame_count(const Motion& motion, double seconds) {
  const double count = std::max(1.0, std::round(seconds / motion.frame_time_s()));
  if (!(count <= kMostFrames) || count * motion.channel_count() > kMaxResampledSamples) {
    return refusal("This gives more frames than can be followed; let it go for fewer seconds.");
  }
  return static_cast<int>(count);
}

}  // namespace

LetGoChoice let_go_choice(const Operation& operation, const OperationValues& values) {
  const auto number = [&](std::string_view name) { return values.numbers[idx(find_parameter(operation, name))]; };
  return {static_cast<FrameIndex>(number("frame")), number("seconds"), static_cast<LetGoChoice::Root>(number("root")), number("start") == 0.0};
}

Result<LetGo> LetGo::make(const Clip& clip, const LetGoChoice& choice) {
  Result<ChainState> state = find_chain_state(clip, choice.frame, choice.is_moving);
  if (!state) return state.error();
  PassiveSettings settings;
  settings.root_held = choice.root == LetGoChoice::Root::Held || (choice.root == LetGoChoice::Root::Auto && roots_stand_still(clip));
  settings.gravity_mps2 = find_gravity(clip.body.gravity_mps2, clip.settings.up_axis);
  if (Status status = settings.root_held ? Status{} : check_can_fall(clip.skeleton); !status) return status.error();
  const Result<int> frame_count = find_frame_count(clip.motion, choice.seconds);
  if (!frame_count) return frame_count.error();
  const Result<ChosenBody> body = find_chosen_body(clip);
  if (!body) return body.error();
  Result<PassiveChain> chain = PassiveChain::make(clip.skeleton, body->body.model, *state, settings);
  if (!chain) return chain.error();
  LetGo result(std::move(*chain), std::move(*state));
  result.start_ = choice.frame;
  result.frame_count_ = *frame_count;
  result.frame_time_s_ = clip.motion.frame_time_s();
  result.is_held_ = settings.root_held;
  result.body_ = fmt::format("{:.3g} kg by {}", body->mass_kg, describe_source(*body));
  return result;
}

Status LetGo::advance(int frames) {
  for (; frames > 0 && done() < all(); --frames) {
    if (Status status = passive_.add_frame(chain_, frame_time_s_); !status) return status;
  }
  return {};
}

Motion LetGo::frames(const Clip& clip) const {
  FrameWriter writer(clip, start_, passive_);
  for (JointIndex joint = 0; joint < clip.skeleton.joint_count(); ++joint) writer.turn(joint, state_.rotations[idx(joint)]);
  if (!is_held_) writer.place_roots(state_);
  return writer.take();
}

std::vector<std::string> LetGo::notes() const {
  return {fmt::format("Energy drifts by {:.1g} of the largest kinetic energy.", passive_.energy_drift),
          fmt::format("{}, {}.", body_, is_held_ ? "held at the root" : "falling freely")};
}

}  // namespace marey
