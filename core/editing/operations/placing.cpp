#include <cmath>
#include <optional>

#include "core/editing/ground_transform.h"
#include "core/editing/operations/families.h"
#include "core/editing/operations/new_samples.h"

namespace marey {
namespace {

using Outcome = Result<OperationOutcome>;

std::optional<JointIndex> first_root(const Skeleton& skeleton) {
  return skeleton.joint_count() > 0 ? std::optional<JointIndex>(0) : std::nullopt;
}

// The position of the first root in the first frame of the range.
glm::dvec3 starting_position(const OperationCall& call) {
  const auto root = first_root(call.clip.skeleton);
  if (!root) return glm::dvec3(0.0);
  return root_position(call.clip.skeleton, call.clip.settings.position_rule, call.clip.motion, *root, call.target.frames.first);
}

// The roots' channels of a moved copy of the range.
Outcome make_moved_edit(const OperationCall& call, const GroundTransform& transform) {
  const Skeleton& skeleton = call.clip.skeleton;
  Motion motion = call.clip.motion.frames_of(call.target.frames);
  if (Status status = move_roots(skeleton, call.clip.settings.position_rule, transform, motion); !status) return status.error();
  std::vector<NewSamples> samples;
  for (ChannelIndex channel = 0; channel < motion.channel_count(); ++channel) {
    if (skeleton.parent(skeleton.channel(channel).joint) != kNoParent) continue;
    const std::span<const double> moved = motion.channel_samples(channel);
    samples.push_back({channel, {moved.begin(), moved.end()}});
  }
  OperationOutcome outcome;
  outcome.edit = blended_edit(call, std::move(samples), Mix::Rotations);
  outcome.edit.name = call.operation.label;
  return outcome;
}

Outcome make_turn(const OperationCall& call) {
  GroundTransform transform{.up = call.clip.settings.up_axis, .angle_deg = call.number("angle")};
  if (call.choice("pivot") == "start") transform.pivot = starting_position(call);
  return make_moved_edit(call, transform);
}

Outcome make_move(const OperationCall& call) {
  return make_moved_edit(call, {.up = call.clip.settings.up_axis,
                                .shift = {call.number("x"), call.number("y"), call.number("z")}});
}

Outcome make_zero_start(const OperationCall& call) {
  const Axis up = call.clip.settings.up_axis;
  const glm::dvec3 start = starting_position(call);
  GroundTransform transform{.up = up, .pivot = start};
  const auto root = first_root(call.clip.skeleton);
  if (root && call.yes("heading")) {
    transform.angle_deg = -twist_deg(call.clip.skeleton, call.clip.motion, *root, call.target.frames.first, up);
  }
  if (call.yes("place")) transform.shift = -start;
  if (!call.yes("height")) transform.shift[static_cast<int>(up)] = 0.0;
  if (call.yes("height") && !call.yes("place")) transform.shift[static_cast<int>(up)] = -start[static_cast<int>(up)];
  return make_moved_edit(call, transform);
}

// Works on the position channels of the roots along the ground.
template <class Work>
Outcome make_ground_edit(const OperationCall& call, Work work) {
  const Skeleton& skeleton = call.clip.skeleton;
  std::vector<NewSamples> samples;
  for (ChannelIndex channel = 0; channel < call.clip.motion.channel_count(); ++channel) {
    const Channel& c = skeleton.channel(channel);
    const bool is_ground = is_position(c.kind) && axis_of(c.kind) != call.clip.settings.up_axis;
    if (!is_ground || skeleton.parent(c.joint) != kNoParent) continue;
    const std::span<const double> before = target_samples(call, channel);
    NewSamples after{channel, {before.begin(), before.end()}};
    work(std::span<double>(after.values));
    samples.push_back(std::move(after));
  }
  OperationOutcome outcome;
  outcome.edit = blended_edit(call, std::move(samples));
  outcome.edit.name = call.operation.label;
  return outcome;
}

struct Ends {
  double first = 0.0;
  double last = 0.0;
};

Ends finite_ends(std::span<const double> values) {
  Ends ends;
  bool found = false;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (!found) ends.first = value;
    ends.last = value;
    found = true;
  }
  return ends;
}

Outcome make_in_place(const OperationCall& call) {
  const bool keeps_sway = call.choice("keep") == "sway";
  return make_ground_edit(call, [keeps_sway](std::span<double> values) {
    const Ends ends = finite_ends(values);
    const double step = values.size() > 1 ? (ends.last - ends.first) / static_cast<double>(values.size() - 1) : 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = keeps_sway ? values[i] - step * static_cast<double>(i) : ends.first;
    }
  });
}

Outcome make_path_scale(const OperationCall& call) {
  const double factor = call.number("factor");
  return make_ground_edit(call, [factor](std::span<double> values) {
    const double first = finite_ends(values).first;
    if (factor == 1.0) return;
    for (double& value : values) value = first + factor * (value - first);
  });
}

constexpr std::string_view kKept[] = {"nothing", "sway"};
constexpr OperationParameter kInPlace[] = {
    {.name = "keep", .label = "Keep", .help = "Nothing of the way, or what is beside the straight line from start to end.",
     .kind = ParameterKind::Choice, .most = 1.0, .choices = kKept}};
constexpr std::string_view kPivots[] = {"start", "origin"};
constexpr OperationParameter kTurn[] = {
    {.name = "angle", .label = "Angle", .unit = "degrees", .help = "About the up axis, counter-clockwise as seen from above.",
     .initial = 0.0, .least = -3600.0, .most = 3600.0},
    {.name = "pivot", .label = "About", .help = "Where the figure stands first, or the world's origin.",
     .kind = ParameterKind::Choice, .most = 1.0, .choices = kPivots}};
constexpr OperationParameter kMove[] = {
    {.name = "x", .label = "X", .unit = "file units", .help = "Along the X axis.", .initial = 0.0, .least = -1e6, .most = 1e6},
    {.name = "y", .label = "Y", .unit = "file units", .help = "Along the Y axis.", .initial = 0.0, .least = -1e6, .most = 1e6},
    {.name = "z", .label = "Z", .unit = "file units", .help = "Along the Z axis.", .initial = 0.0, .least = -1e6, .most = 1e6}};
constexpr OperationParameter kZeroStart[] = {
    {.name = "place", .label = "Place", .help = "The first frame stands over the origin.", .kind = ParameterKind::YesNo,
     .initial = 1.0, .most = 1.0},
    {.name = "heading", .label = "Heading", .help = "The first frame is turned by nothing about the up axis.",
     .kind = ParameterKind::YesNo, .initial = 1.0, .most = 1.0},
    {.name = "height", .label = "Height", .help = "The root's height is taken off as well.", .kind = ParameterKind::YesNo,
     .initial = 0.0, .most = 1.0}};
constexpr OperationParameter kPathScale[] = {
    {.name = "factor", .label = "Factor", .help = "How much longer the way along the ground becomes.", .initial = 1.0,
     .least = -100.0, .most = 100.0}};

constexpr Operation kPlacing[] = {
    {.id = "in-place", .label = "In place", .group = "Clip", .help = "Lets the figure move where it stands.",
     .reach = OperationReach::Roots, .parameters = kInPlace, .make = make_in_place},
    {.id = "turn", .label = "Turn", .group = "Clip", .help = "Turns the whole movement about the up axis.",
     .reach = OperationReach::Roots, .parameters = kTurn, .make = make_turn},
    {.id = "move", .label = "Move", .group = "Clip", .help = "Shifts the whole movement.", .reach = OperationReach::Roots,
     .parameters = kMove, .make = make_move},
    {.id = "zero-start", .label = "Zero the start", .group = "Clip",
     .help = "Turns and shifts the movement so that it starts over the origin, facing ahead.",
     .reach = OperationReach::Roots, .parameters = kZeroStart, .make = make_zero_start},
    {.id = "path-scale", .label = "Scale the path", .group = "Clip",
     .help = "Makes the way along the ground longer or shorter; heights stay.", .reach = OperationReach::Roots,
     .parameters = kPathScale, .make = make_path_scale}};

}  // namespace

std::span<const Operation> placing_operations() { return kPlacing; }

}  // namespace marey
