#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/editing/operations/families.h"
#include "core/editing/operations/frame_edit.h"
#include "core/editing/warp_curve.h"
#include "core/motion/frame_time.h"
#include "core/motion/resampling.h"

namespace marey {
namespace {

using Outcome = Result<OperationOutcome>;

Error refusal(std::string message) { return {DiagnosticCode::InvalidArgument, {}, std::move(message), {}, {}}; }

// The range over so many steps from frame to frame, its first and last frame kept.
Outcome make_stretched_edit(const OperationCall& call, double steps_wanted) {
  const FrameRange range = call.target.frames;
  if (range.count < 2) return OperationOutcome{};
  const double steps = std::max(1.0, std::round(steps_wanted));
  if ((steps + 1.0) * std::max(call.clip.motion.channel_count(), 1) > kMaxResampledSamples) {
    return refusal("This gives more samples than fit in memory.");
  }
  std::vector<double> times;
  const auto count = static_cast<int>(steps) + 1;
  times.reserve(idx(count));
  for (int i = 0; i < count; ++i) times.push_back(snapped_to_frame(range.first + i * (range.count - 1.0) / steps));
  return make_retimed_edit(call, range, times);
}

Outcome make_retime(const OperationCall& call) {
  return make_stretched_edit(call, (call.target.frames.count - 1) / call.number("speed"));
}

Outcome make_set_duration(const OperationCall& call) {
  return make_stretched_edit(call, call.number("seconds") / call.clip.motion.frame_time_s());
}

Outcome make_warp(const OperationCall& call) {
  const int frame_count = call.clip.motion.frame_count();
  if (frame_count == 0) return OperationOutcome{};
  Result<std::vector<WarpPoint>> points = parse_warp_points(call.text("points"));
  if (!points) return points.error();
  const double most = kMaxResampledSamples / std::max(call.clip.motion.channel_count(), 1);
  const Result<std::vector<double>> times = make_warped_times(std::move(*points), frame_count, most);
  if (!times) return times.error();
  return make_retimed_edit(call, {0, frame_count}, *times);
}

Outcome make_resample(const OperationCall& call) {
  const Clip& clip = call.clip;
  Result<Motion> motion = resampled(clip.skeleton, clip.motion, call.number("rate"));
  if (!motion) return motion.error();
  OperationOutcome outcome;
  const double frame_time_s = motion->frame_time_s();
  if (frame_time_s == clip.motion.frame_time_s()) return outcome;
  if (clip.motion.frame_count() > 0) {
    const double ratio = display_frame_rate_hz(clip.motion.frame_time_s()) / call.number("rate");
    std::vector<double> times;
    for (int i = 0; i < motion->frame_count(); ++i) times.push_back(snapped_to_frame(i * ratio));
    outcome.edit = make_frames_edit(call, {0, clip.motion.frame_count()}, std::move(*motion), kept_file_frames(clip, times));
  }
  outcome.edit.name = fmt::format("Resample to {:.6g} frames a second", call.number("rate"));
  outcome.edit.frame_time_s = frame_time_s;
  return outcome;
}

constexpr OperationParameter kRetime[] = {
    {.name = "speed", .label = "Speed", .help = "2 plays twice as fast, 0.5 half as fast.", .initial = 1.0, .least = 0.01,
     .most = 100.0}};
constexpr OperationParameter kDuration[] = {
    {.name = "seconds", .label = "Duration", .unit = "s", .help = "From the first to the last frame of the range.",
     .initial = 1.0, .least = 0.001, .most = 1e6}};
constexpr OperationParameter kWarp[] = {
    {.name = "points", .label = "Points", .help = "FRAME:FRAME pairs: which frame comes where, such as 1:1,50:80,100:120.",
     .kind = ParameterKind::Points}};
constexpr OperationParameter kResample[] = {
    {.name = "rate", .label = "Frame rate", .unit = "frames a second", .help = "The duration stays.", .initial = 30.0,
     .least = 0.11, .most = 10000.0}};

constexpr Operation kTiming[] = {
    {.id = "retime", .label = "Change speed", .group = "Time",
     .help = "Plays the range faster or slower; the frame rate stays.", .reach = OperationReach::Frames,
     .parameters = kRetime, .make = make_retime},
    {.id = "set-duration", .label = "Set duration", .group = "Time", .help = "Stretches the range to a duration.",
     .reach = OperationReach::Frames, .parameters = kDuration, .make = make_set_duration},
    {.id = "warp", .label = "Warp time", .group = "Time", .help = "Moves frames to other times; between them time flows smoothly.",
     .reach = OperationReach::Clip, .parameters = kWarp, .make = make_warp},
    {.id = "resample", .label = "Resample", .group = "Time",
     .help = "Gives the clip another frame rate; rotations are resampled as rotations.", .reach = OperationReach::Clip,
     .parameters = kResample, .make = make_resample}};

}  // namespace

std::span<const Operation> timing_operations() { return kTiming; }

}  // namespace marey
