#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/biomechanics/chosen_body.h"
#include "core/biomechanics/passive_chain.h"
#include "core/biomechanics/support.h"
#include "core/editing/operations/families.h"
#include "core/editing/operations/frame_edit.h"
#include "core/math/angle.h"
#include "core/math/euler.h"
#include "core/motion/euler_channels.h"
#include "core/motion/resampling.h"

namespace marey {
namespace {

using Outcome = Result<OperationOutcome>;

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

Result<int> find_frame_count(const OperationCall& call) {
  const Motion& motion = call.clip.motion;
  const double count = std::max(1.0, std::round(call.number("seconds") / motion.frame_time_s()));
  if (count > kMostFrames || count * motion.channel_count() > kMaxResampledSamples) {
    return refusal("This gives more frames than can be followed; let it go for fewer seconds.");
  }
  return static_cast<int>(count);
}

Outcome make_let_go(const OperationCall& call) {
  const Clip& clip = call.clip;
  const FrameIndex start = call.whole("frame");
  const std::string_view root = call.choice("root");
  const Result<ChainState> state = find_chain_state(clip, start, call.choice("start") == "as-it-moves");
  if (!state) return state.error();
  PassiveSettings settings;
  settings.root_held = root == "held" || (root == "auto" && roots_stand_still(clip));
  settings.gravity_mps2 = glm::dvec3(0.0);
  settings.gravity_mps2[static_cast<int>(clip.settings.up_axis)] = -9.81;
  if (Status status = settings.root_held ? Status{} : check_can_fall(clip.skeleton); !status) return status.error();
  const Result<int> frame_count = find_frame_count(call);
  if (!frame_count) return frame_count.error();
  const Result<ChosenBody> body = find_chosen_body(clip);
  if (!body) return body.error();
  const Result<PassiveChain> chain = PassiveChain::make(clip.skeleton, body->body.model, *state, settings);
  if (!chain) return chain.error();
  const Result<PassiveMotion> passive = find_passive_motion(*chain, clip.motion.frame_time_s(), *frame_count);
  if (!passive) return passive.error();
  FrameWriter writer(clip, start, *passive);
  for (JointIndex joint = 0; joint < clip.skeleton.joint_count(); ++joint) writer.turn(joint, state->rotations[idx(joint)]);
  if (!settings.root_held) writer.place_roots(*state);
  OperationOutcome outcome;
  const FrameRange removed{start + 1, clip.motion.frame_count() - start - 1};
  outcome.edit = make_frames_edit(call, removed, writer.take(), std::vector<FrameIndex>(idx(*frame_count), kNewFrame));
  outcome.notes = {fmt::format("Energy drifts by {:.1g} of the largest kinetic energy.", passive->energy_drift),
                   fmt::format("{:.3g} kg by {}, {}.", body->mass_kg, body_table_name(body->table),
                               settings.root_held ? "held at the root" : "falling freely")};
  return outcome;
}

constexpr std::string_view kRoots[] = {"auto", "held", "free"};
constexpr std::string_view kStarts[] = {"as-it-moves", "at-rest"};
constexpr OperationParameter kLetGo[] = {
    {.name = "frame", .label = "From frame", .help = "The last frame that stays; the figure is let go in its pose.",
     .kind = ParameterKind::Frame, .initial = 0.0, .least = 0.0, .most = 1e9},
    {.name = "seconds", .label = "Duration", .unit = "s", .help = "How long it is watched.", .initial = 5.0, .least = 0.01,
     .most = 60.0},
    {.name = "root", .label = "Root", .help = "It hangs on its root or falls; by itself it hangs where the root stands still.",
     .kind = ParameterKind::Choice, .most = 2.0, .choices = kRoots},
    {.name = "start", .label = "Start", .help = "With the speeds that the clip has there, or with none.",
     .kind = ParameterKind::Choice, .most = 1.0, .choices = kStarts}};

constexpr Operation kMechanics[] = {
    {.id = "let-go", .label = "Let go", .group = "Mechanics",
     .help = "From a frame on, gravity alone moves the figure, without muscles and without a floor.",
     .reach = OperationReach::Clip, .parameters = kLetGo, .make = make_let_go}};

}  // namespace

std::span<const Operation> mechanics_operations() { return kMechanics; }

}  // namespace marey
