#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/editing/operations/families.h"
#include "core/editing/operations/new_samples.h"
#include "core/signal/rotation_filter.h"
#include "core/math/angle.h"
#include "core/motion/sampling.h"
#include "core/signal/butterworth.h"
#include "core/signal/gaussian_smoothing.h"

namespace marey {
namespace {

using Outcome = Result<OperationOutcome>;

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

Outcome make_unroll(const OperationCall& call) {
  return make_curves_edit(call, [](const Curve& curve, std::span<double> values) {
    if (!is_rotation(curve.kind)) return;
    double previous = curve.before();
    for (double& value : values) {
      if (!std::isfinite(value)) continue;
      if (std::abs(value - previous) > 180.0) value = nearest_turn(value, previous);
      previous = value;
    }
  });
}

// The angles before the range, else the first of the range, as they are or in their canonical form.
glm::dvec3 starting_angles(const OperationCall& call, const EulerChannels& euler) {
  const FrameIndex first = call.target.frames.first;
  if (call.choice("start") == "before" && first > 0) return angles_deg_of(call.clip.motion, euler, first - 1);
  const glm::dvec3 own = angles_deg_of(call.clip.motion, euler, first);
  if (call.choice("start") != "canonical" || !is_finite(own)) return own;
  return euler_from_rotation(euler.order, glm::mat3_cast(rotation_from_euler(euler.order, own)));
}

// Two angles have no second solution: only whole turns are free.
glm::dvec3 solved_near(const EulerChannels& euler, const glm::dvec3& own, const glm::dvec3& previous) {
  if (euler.count < 3) return nearest_turn(own, previous);
  return euler_near(euler.order, glm::mat3_cast(rotation_from_euler(euler.order, own)), previous);
}

double largest_difference(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 d = glm::abs(a - b);
  return std::max({d.x, d.y, d.z});
}

std::vector<NewSamples> solve_joint(const OperationCall& call, const EulerChannels& euler) {
  constexpr double kSameDeg = 1e-9;
  std::vector<NewSamples> samples = copied_angles(call, euler);
  glm::dvec3 previous = starting_angles(call, euler);
  for (int i = 0; i < call.target.frames.count; ++i) {
    const glm::dvec3 own = angles_deg_of(call.clip.motion, euler, call.target.frames.first + i);
    if (!is_finite(own)) continue;
    const glm::dvec3 solved = is_finite(previous) ? solved_near(euler, own, previous) : own;
    // What is the best already keeps its bits.
    const bool stays = largest_difference(solved, own) <= kSameDeg;
    if (!stays) set_angles(samples, idx(i), solved);
    previous = stays ? own : solved;
  }
  return samples;
}

Outcome make_solve_angles(const OperationCall& call) {
  OperationOutcome outcome;
  std::vector<NewSamples> samples;
  for (const JointIndex joint : call.target.joints) {
    const auto euler = find_euler_channels(call.clip.skeleton, joint);
    if (euler) append(samples, solve_joint(call, *euler));
  }
  std::sort(samples.begin(), samples.end(), [](const NewSamples& a, const NewSamples& b) { return a.channel < b.channel; });
  outcome.edit = blended_edit(call, std::move(samples), Mix::Rotations);
  return outcome;
}

/// The filter that the parameters ask for, and how far it looks.
struct AskedFilter {
  CurveFilter filter;
  int reach = 0;
};

Result<AskedFilter> asked_filter(const OperationCall& call) {
  if (call.choice("method") == "gaussian") {
    const double sigma = call.number("sigma");
    const auto filter = [sigma](std::span<const double> curve, std::span<double> result) {
      compute_gaussian_smoothed(curve, {0, size_of(curve)}, sigma, result);
    };
    return AskedFilter{filter, static_cast<int>(4.0 * sigma) + 1};
  }
  const double rate_hz = 1.0 / call.clip.motion.frame_time_s();
  const double cutoff_hz = call.number("cutoff");
  if (cutoff_hz >= 0.5 * rate_hz) {
    return Error{DiagnosticCode::InvalidArgument, {},
                 fmt::format("'cutoff' is below half the frame rate, {:.6g} Hz, not {}.", 0.5 * rate_hz, cutoff_hz), {}, {}};
  }
  const auto filter = [=](std::span<const double> curve, std::span<double> result) {
    compute_butterworth(curve, cutoff_hz, rate_hz, result);
  };
  return AskedFilter{filter, static_cast<int>(std::min(5.2 * rate_hz / cutoff_hz, 1e8))};
}

std::vector<NewSamples> filter_joint(const OperationCall& call, JointIndex joint, const EulerChannels& euler,
                                     const AskedFilter& asked) {
  const Motion& motion = call.clip.motion;
  std::vector<glm::dquat> rotations;
  for (FrameIndex frame = 0; frame < motion.frame_count(); ++frame) {
    rotations.push_back(joint_rotation(call.clip.skeleton, motion, joint, frame));
  }
  filter_rotations(rotations, asked.reach, asked.filter);
  std::vector<NewSamples> samples = copied_angles(call, euler);
  for (int i = 0; i < call.target.frames.count; ++i) {
    const FrameIndex frame = call.target.frames.first + i;
    const glm::dvec3 own = angles_deg_of(motion, euler, frame);
    if (is_finite(own)) set_angles(samples, idx(i), euler_near(euler.order, glm::mat3_cast(rotations[idx(frame)]), own));
  }
  return samples;
}

// Hinges turn by one angle, which is filtered itself.
std::vector<NewSamples> filter_angles(const OperationCall& call, JointIndex joint, const AskedFilter& asked) {
  std::vector<NewSamples> samples;
  std::vector<double> whole(idx(call.clip.motion.frame_count()));
  ChannelIndex channel = call.clip.skeleton.first_channel(joint);
  for (const Channel& c : call.clip.skeleton.channels(joint)) {
    if (is_rotation(c.kind)) {
      asked.filter(call.clip.motion.channel_samples(channel), whole);
      const auto begin = whole.begin() + call.target.frames.first;
      samples.push_back({channel, {begin, begin + call.target.frames.count}});
    }
    ++channel;
  }
  return samples;
}

Outcome make_rotation_filter(const OperationCall& call) {
  const Result<AskedFilter> asked = asked_filter(call);
  if (!asked) return asked.error();
  std::vector<NewSamples> samples;
  for (const JointIndex joint : call.target.joints) {
    const auto euler = find_euler_channels(call.clip.skeleton, joint);
    append(samples, euler ? filter_joint(call, joint, *euler, *asked) : filter_angles(call, joint, *asked));
  }
  std::sort(samples.begin(), samples.end(), [](const NewSamples& a, const NewSamples& b) { return a.channel < b.channel; });
  OperationOutcome outcome;
  outcome.edit = blended_edit(call, std::move(samples), Mix::Rotations);
  return outcome;
}

constexpr std::string_view kStarts[] = {"before", "own", "canonical"};
constexpr OperationParameter kSolve[] = {
    {.name = "start", .label = "Start", .help = "What the first angles are to be near: those before the range, their own, or the middle one within 90 degrees.",
     .kind = ParameterKind::Choice, .most = 2.0, .choices = kStarts}};
constexpr std::string_view kMethods[] = {"gaussian", "butterworth"};
constexpr OperationParameter kRotationFilter[] = {
    {.name = "method", .label = "Method", .help = "Which filter.", .kind = ParameterKind::Choice, .most = 1.0, .choices = kMethods},
    {.name = "sigma", .label = "Width", .unit = "frames", .help = "Of the Gaussian bell.", .initial = 2.0,
     .least = 0.1, .most = 1000.0},
    {.name = "cutoff", .label = "Cut-off", .unit = "Hz", .help = "Of the Butterworth filter.", .initial = 6.0, .least = 0.01,
     .most = 1000.0}};

constexpr Operation kRotations[] = {
    {.id = "unroll", .label = "Unroll", .group = "Rotation",
     .help = "Takes whole turns out of the steps from frame to frame; no rotation changes.", .make = make_unroll},
    {.id = "solve-angles", .label = "Solve angles again", .group = "Rotation",
     .help = "Describes the same rotations by the angles nearest to those of the frame before, through gimbal lock.",
     .reach = OperationReach::Joints, .parameters = kSolve, .make = make_solve_angles},
    {.id = "rotation-filter", .label = "Filter rotations", .group = "Rotation",
     .help = "Filters the rotation of a joint instead of its angles one by one.", .reach = OperationReach::Joints,
     .parameters = kRotationFilter, .make = make_rotation_filter}};

}  // namespace

std::span<const Operation> rotation_operations() { return kRotations; }

}  // namespace marey
