#include <algorithm>
#include <cmath>
#include <utility>

#include "core/editing/ground_transform.h"
#include "core/editing/operations/families.h"
#include "core/editing/operations/frame_edit.h"
#include "core/editing/operations/new_samples.h"
#include "core/editing/operations/other_clip.h"
#include "core/kinematics/forward_kinematics.h"
#include "core/motion/resampling.h"

namespace marey {
namespace {

using Outcome = Result<OperationOutcome>;

std::vector<double> positions_of(const Clip& clip, const Motion& motion, FrameRange frames) {
  std::vector<double> positions(idx(frames.count) * idx(clip.skeleton.node_count()) * 3);
  compute_world_positions(clip.skeleton, motion, frames, clip.settings.position_rule, positions);
  return positions;
}

// Turns and shifts the other movement so that its first frames lie on the clip's last ones.
Status align(const Clip& clip, int overlap, Motion& other) {
  const std::vector<double> last = positions_of(clip, clip.motion, {clip.motion.frame_count() - overlap, overlap});
  const std::vector<double> first = positions_of(clip, other, {0, overlap});
  const GroundTransform transform = find_alignment(clip.settings.up_axis, first, last);
  return move_roots(clip.skeleton, clip.settings.position_rule, transform, other);
}

// From the clip into the other one: 0 before the overlap, 1 behind it (Kovar, Gleicher and Pighin 2002, mirrored in time).
std::vector<double> overlap_weights(int overlap) {
  std::vector<double> weights;
  for (int i = 0; i < overlap; ++i) {
    const double p = (i + 1.0) / (overlap + 1.0);
    weights.push_back(p * p * (3.0 - 2.0 * p));
  }
  return weights;
}

Outcome make_append(const OperationCall& call) {
  const Clip& clip = call.clip;
  const int frame_count = clip.motion.frame_count();
  if (frame_count == 0) return Error{DiagnosticCode::InvalidArgument, {}, "The clip has no frame to append to.", {}, {}};
  Result<OtherMotion> other = adopt_motion(clip, *call.values.other, frame_count - 1);
  if (!other) return other.error();
  Motion& added = other->motion;
  OperationOutcome outcome{{}, std::move(other->notes)};
  if (added.frame_count() == 0) return outcome;
  const int blended = std::min({call.whole("blend"), frame_count, added.frame_count()});
  if (call.yes("align")) {
    if (Status status = align(clip, std::max(blended, 1), added); !status) return status.error();
  }
  const FrameRange removed{frame_count - blended, blended};
  if (blended > 0) {
    const Motion overlap = mixed_motion(clip.skeleton, clip.motion.frames_of(removed), added.frames_of({0, blended}),
                                        overlap_weights(blended));
    added = added.with_frames_replaced({0, blended}, overlap);
  }
  std::vector<FrameIndex> file_frames(idx(added.frame_count()), kNewFrame);
  outcome.edit = make_frames_edit(call, removed, std::move(added), std::move(file_frames));
  return outcome;
}

Outcome make_splice(const OperationCall& call) {
  const FrameRange range = call.target.frames;
  const Result<OtherMotion> other = adopt_motion(call.clip, *call.values.other, range.first);
  if (!other) return other.error();
  const int first = call.whole("at");
  std::vector<NewSamples> samples;
  for (const ChannelIndex channel : call.target.channels) {
    const JointIndex joint = call.clip.skeleton.channel(channel).joint;
    if (std::binary_search(other->missing.begin(), other->missing.end(), joint)) continue;
    const std::span<const double> before = target_samples(call, channel);
    NewSamples after{channel, {before.begin(), before.end()}};
    const std::span<const double> source = other->motion.channel_samples(channel);
    for (int i = 0; i < range.count && i < size_of(source) - first; ++i) after.values[idx(i)] = source[idx(first + i)];
    samples.push_back(std::move(after));
  }
  OperationOutcome outcome{{}, other->notes};
  if (size_of(call.target.channels) > 0 && other->motion.frame_count() - first < range.count) {
    outcome.notes.emplace_back("The other clip ends before the range; the frames behind its end stay.");
  }
  outcome.edit = blended_edit(call, std::move(samples), Mix::Rotations);
  return outcome;
}

constexpr OperationParameter kAppend[] = {
    {.name = "from", .label = "Clip", .help = "The clip that comes behind this one.", .kind = ParameterKind::File},
    {.name = "blend", .label = "Blend", .unit = "frames", .help = "So many last frames flow into as many first ones.",
     .kind = ParameterKind::Whole, .initial = 10.0, .least = 0.0, .most = 1e5},
    {.name = "align", .label = "Align", .help = "Turn and shift it on the ground so that it begins where this one ends.",
     .kind = ParameterKind::YesNo, .initial = 1.0, .most = 1.0}};
constexpr OperationParameter kSplice[] = {
    {.name = "from", .label = "Clip", .help = "The clip whose joints are taken.", .kind = ParameterKind::File},
    {.name = "at", .label = "From frame", .help = "The other clip's frame that comes to the first frame of the range.",
     .kind = ParameterKind::Frame, .initial = 0.0, .least = 0.0, .most = 1e9}};

constexpr Operation kJoining[] = {
    {.id = "append", .label = "Append clip", .group = "Join", .help = "Lets another clip follow this one.",
     .reach = OperationReach::Clip, .parameters = kAppend, .make = make_append},
    {.id = "splice", .label = "Splice joints", .group = "Join", .help = "Gives joints the movement that they have in another clip.",
     .reach = OperationReach::Joints, .parameters = kSplice, .make = make_splice}};

}  // namespace

std::span<const Operation> joining_operations() { return kJoining; }

}  // namespace marey
