#include <fmt/format.h>

#include <algorithm>

#include "core/editing/clip_operations.h"
#include "core/editing/contact_edits.h"
#include "core/editing/operations/families.h"
#include "core/editing/operations/frame_edit.h"
#include "core/motion/resampling.h"

namespace marey {
namespace {

using Outcome = Result<OperationOutcome>;

Outcome make_trim(const OperationCall& call) {
  const FrameRange kept = call.target.frames;
  const int frame_count = call.clip.motion.frame_count();
  OperationOutcome outcome;
  if (kept.count == frame_count) return outcome;
  // What lies at an end can go alone; else the range comes in the place of all.
  if (kept.first == 0) {
    outcome.edit = make_remove_frames_edit({kept.end(), frame_count - kept.end()});
  } else if (kept.end() == frame_count) {
    outcome.edit = make_remove_frames_edit({0, kept.first});
  } else {
    outcome.edit = make_frames_edit(call, {0, frame_count}, call.clip.motion.frames_of(kept), file_frames_of(call.clip, kept));
    // Frames that an edit made have no number that would say where they stay.
    if (!call.clip.body.contacts.empty()) {
      outcome.edit.body = call.clip.body;
      outcome.edit.body->contacts = contacts_within(call.clip.body.contacts, kept);
    }
  }
  outcome.edit.name = fmt::format("Trim to frames {} to {}", kept.first + 1, kept.end());
  return outcome;
}

Outcome make_cut(const OperationCall& call) {
  OperationOutcome outcome;
  outcome.edit = make_remove_frames_edit(call.target.frames);
  return outcome;
}

Outcome make_insert(const OperationCall& call) {
  const Clip& clip = call.clip;
  const int frame_count = clip.motion.frame_count();
  const int count = call.whole("count");
  if (frame_count == 0 || count == 0) return OperationOutcome{};
  const FrameIndex at = std::min(call.whole("at"), frame_count);
  const FrameIndex before = std::max(at - 1, 0);
  const bool holds = call.choice("fill") == "hold" || at == 0 || at == frame_count;
  std::vector<double> times;
  if (static_cast<double>(count) * clip.motion.channel_count() <= kMaxResampledSamples) {
    for (int i = 0; i < count; ++i) times.push_back(holds ? before : before + (i + 1.0) / (count + 1.0));
  }
  if (times.empty()) return Error{DiagnosticCode::InvalidArgument, {}, "This gives more samples than fit in memory.", {}, {}};
  OperationOutcome outcome;
  outcome.edit = make_frames_edit(call, {at, 0}, resampled_at(clip.skeleton, clip.motion, times),
                                  std::vector<FrameIndex>(idx(count), kNewFrame));
  return outcome;
}

constexpr std::string_view kFills[] = {"hold", "blend"};
constexpr OperationParameter kInsert[] = {
    {.name = "at", .label = "Before frame", .help = "The new frames come before this one; behind the last frame they are the end.",
     .kind = ParameterKind::Frame, .initial = 0.0, .least = 0.0, .most = 1e9},
    {.name = "count", .label = "Frames", .help = "How many.", .kind = ParameterKind::Whole, .initial = 1.0, .least = 0.0, .most = 1e7},
    {.name = "fill", .label = "Fill", .help = "The pose before is held, or flows into the pose behind.",
     .kind = ParameterKind::Choice, .most = 1.0, .choices = kFills}};

constexpr Operation kFrames[] = {
    {.id = "trim", .label = "Trim", .group = "Frames", .help = "Keeps the frames of the range alone.",
     .reach = OperationReach::Frames, .make = make_trim},
    {.id = "cut", .label = "Cut", .group = "Frames", .help = "Takes the frames of the range out; those behind move up.",
     .reach = OperationReach::Frames, .make = make_cut},
    {.id = "insert", .label = "Insert frames", .group = "Frames", .help = "Makes room in the clip.",
     .reach = OperationReach::Clip, .parameters = kInsert, .make = make_insert}};

}  // namespace

std::span<const Operation> frame_operations() { return kFrames; }

}  // namespace marey
