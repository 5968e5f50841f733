#include "core/editing/operations/frame_edit.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "core/motion/resampling.h"

namespace marey {
Edit make_frames_edit(const OperationCall& call, FrameRange removed, Motion inserted, std::vector<FrameIndex> file_frames) {
  Edit edit;
  edit.name = call.operation.label;
  edit.frames = FramesChange{removed, std::move(inserted), std::move(file_frames)};
  return edit;
}

Result<OperationOutcome> make_retimed_edit(const OperationCall& call, FrameRange removed, std::span<const double> times) {
  const Clip& clip = call.clip;
  if (static_cast<double>(times.size()) * clip.motion.channel_count() > kMaxResampledSamples) {
    return Error{DiagnosticCode::InvalidArgument, {}, "This gives more samples than fit in memory.", {}, {}};
  }
  OperationOutcome outcome;
  if (clip.motion.frame_count() == 0) return outcome;
  outcome.edit = make_frames_edit(call, removed, resampled_at(clip.skeleton, clip.motion, times), kept_file_frames(clip, times));
  return outcome;
}

std::vector<FrameIndex> kept_file_frames(const Clip& clip, std::span<const double> times) {
  const std::vector<FrameIndex> present = file_frames_of(clip, {0, clip.motion.frame_count()});
  std::vector<FrameIndex> kept;
  kept.reserve(times.size());
  double last = -1.0;
  for (const double time : times) {
    const bool is_frame = time == std::round(time) && time > last;
    kept.push_back(is_frame ? present[static_cast<std::size_t>(time)] : kNewFrame);
    if (is_frame) last = time;
  }
  return kept;
}

std::vector<FrameIndex> file_frames_of(const Clip& clip, FrameRange frames) {
  if (!clip.file_frames.empty()) {
    const auto begin = clip.file_frames.begin() + frames.first;
    return {begin, begin + frames.count};
  }
  std::vector<FrameIndex> all(idx(frames.count));
  std::iota(all.begin(), all.end(), frames.first);
  return all;
}

}  // namespace marey
