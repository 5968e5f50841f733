#include "core/document/document.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/bits.h"
#include "core/bvh/writer.h"
#include "core/kinematics/clip_bounds.h"

namespace marey {
namespace {

constexpr double kHumanStatureM = 1.7;
constexpr double kDefaultMetresPerUnit = 0.01;
// Metre, centimetre, millimetre, inch, and the unit of the CMU recordings.
constexpr std::array kMetresPerUnit = {1.0, 0.01, 0.001, 0.0254, 0.0254 / 0.45};

ClipSettings guess_settings(const BvhClip& clip) {
  ClipSettings settings;
  settings.position_rule = clip.position_rule;
  settings.up_axis = find_up_axis(clip.skeleton, clip.motion, clip.position_rule);
  settings.metres_per_unit = guess_metres_per_unit(clip.skeleton);
  return settings;
}

}  // namespace

Document::Document(BvhClip clip, std::string file_name) : file_name_(std::move(file_name)) {
  clip_.settings = guess_settings(clip);
  clip_.skeleton = std::move(clip.skeleton);
  clip_.motion = std::move(clip.motion);
  style_ = std::move(clip.style);
  diagnostics_ = std::move(clip.diagnostics);
}

Status Document::apply(Edit edit) {
  return apply_gesture(0, [&](const Clip&) { return std::move(edit); });
}

Status Document::apply_gesture(GestureId gesture, const History::MakeEdit& make_edit) {
  keep_gesture_ghosts(gesture);
  return history_.apply_gesture(clip_, gesture, [&](const Clip& clip) {
    Edit edit = make_edit(clip);
    if (check_edit(clip, edit)) {
      edit = reduced_to_changes(clip, std::move(edit));
      keep_ghosts(edit);
    }
    return edit;
  });
}

void Document::cancel_gesture(GestureId gesture) {
  keep_gesture_ghosts(gesture);
  history_.cancel_gesture(clip_, gesture);
}

bool Document::undo() {
  if (const Edit* edit = history_.undo_edit()) keep_ghosts(*edit);
  return history_.undo(clip_);
}

bool Document::redo() {
  if (const Edit* edit = history_.redo_edit()) keep_ghosts(*edit);
  return history_.redo(clip_);
}

std::string Document::save_text() const { return write_bvh(clip_.skeleton, clip_.motion, style_); }

void Document::mark_saved() {
  history_.mark_saved();
  saved_samples_.clear();
  saved_offsets_.clear();
  saved_frame_time_s_.reset();
}

std::span<const double> Document::saved_samples(ChannelIndex channel) const {
  const auto found = saved_samples_.find(channel);
  return found == saved_samples_.end() ? std::span<const double>() : std::span<const double>(found->second);
}

Changes Document::find_changes() const {
  Changes changes;
  for (const auto& [channel, saved] : saved_samples_) {
    const std::span<const double> samples = clip_.motion.channel_samples(channel);
    const std::int64_t before = changes.samples;
    for (FrameIndex frame = 0; frame < size_of(saved); ++frame) {
      if (same_bits(saved[idx(frame)], samples[idx(frame)])) continue;
      ++changes.samples;
      changes.frames = hull(changes.frames, {frame, 1});
    }
    changes.channels += changes.samples > before ? 1 : 0;
  }
  for (const auto& [node, saved] : saved_offsets_) changes.offsets += saved != clip_.skeleton.node(node).offset ? 1 : 0;
  changes.frame_time = saved_frame_time_s_ && *saved_frame_time_s_ != clip_.motion.frame_time_s();
  return changes;
}

void Document::keep_ghosts(const Edit& edit) {
  for (const SamplesChange& change : edit.samples) {
    if (saved_samples_.contains(change.channel)) continue;
    const std::span<const double> samples = clip_.motion.channel_samples(change.channel);
    saved_samples_.emplace(change.channel, std::vector<double>(samples.begin(), samples.end()));
  }
  for (const OffsetChange& change : edit.offsets) {
    saved_offsets_.try_emplace(change.node, clip_.skeleton.node(change.node).offset);
  }
  if (edit.frame_time_s && !saved_frame_time_s_) saved_frame_time_s_ = clip_.motion.frame_time_s();
}

// A file saved in the middle of a gesture holds the gesture's state, which is about to be taken back.
void Document::keep_gesture_ghosts(GestureId gesture) {
  if (history_.is_in_gesture(gesture)) keep_ghosts(*history_.undo_edit());
}

double guess_metres_per_unit(const Skeleton& skeleton) {
  const double stature = compute_stature(skeleton);
  if (!std::isfinite(stature) || stature <= 0.0) return kDefaultMetresPerUnit;
  double best = kDefaultMetresPerUnit;
  double best_distance = std::numeric_limits<double>::infinity();
  for (const double candidate : kMetresPerUnit) {
    const double distance = std::abs(std::log(candidate * stature / kHumanStatureM));
    if (distance >= best_distance) continue;
    best = candidate;
    best_distance = distance;
  }
  return best;
}

}  // namespace marey
