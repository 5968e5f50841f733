#include "core/document/document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/base/bits.h"
#include "core/base/scope_exit.h"
#include "core/bvh/writer.h"
#include "core/kinematics/clip_bounds.h"
#include "core/text/readable.h"

namespace marey {
namespace {

constexpr double kHumanStatureM = 1.7;
constexpr double kDefaultMetresPerUnit = 0.01;
constexpr std::array kLengthUnits = {LengthUnit{"m", 1.0}, LengthUnit{"cm", 0.01}, LengthUnit{"mm", 0.001},
                                     LengthUnit{"inch", 0.0254}, LengthUnit{"CMU unit", 0.0254 / 0.45}};

ClipSettings guess_settings(const BvhClip& clip) {
  ClipSettings settings;
  settings.position_rule = clip.position_rule;
  settings.up_axis = find_up_axis(clip.skeleton, clip.motion, clip.position_rule);
  settings.metres_per_unit = guess_metres_per_unit(clip.skeleton);
  settings.names_in = clip.names_in;
  return settings;
}

/// Clip::file_frames with nothing left to be understood.
std::vector<FrameIndex> as_listed(const std::vector<FrameIndex>& file_frames, int frame_count) {
  if (!file_frames.empty()) return file_frames;
  std::vector<FrameIndex> all(idx(frame_count));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Where each of `wanted` stands in `frames`, -1 where it does not or is a new frame. Both rise but for new frames.
std::vector<FrameIndex> places_in(const std::vector<FrameIndex>& frames, const std::vector<FrameIndex>& wanted) {
  std::vector<FrameIndex> places;
  places.reserve(wanted.size());
  auto at = frames.begin();
  for (const FrameIndex frame : wanted) {
    while (frame != kNewFrame && at != frames.end() && *at < frame) ++at;
    places.push_back(frame != kNewFrame && at != frames.end() && *at == frame ? static_cast<FrameIndex>(at - frames.begin()) : -1);
  }
  return places;
}

}  // namespace

Clip make_clip(BvhClip clip) {
  const ClipSettings settings = guess_settings(clip);
  return {std::move(clip.skeleton), std::move(clip.motion), settings};
}

Document::Document(BvhClip clip, std::string file_name) : file_name_(std::move(file_name)) {
  style_ = std::move(clip.style);
  diagnostics_ = std::move(clip.diagnostics);
  declared_frames_ = clip.declared_frames;
  clip_ = make_clip(std::move(clip));
}

const Diagnostics& Document::diagnostics() const {
  if (readable_in_ != clip_.settings.names_in) {
    readable_diagnostics_ = readable(diagnostics_, clip_.settings.names_in);
    readable_in_ = clip_.settings.names_in;
  }
  return readable_diagnostics_;
}

Status Document::apply(Edit edit) {
  return apply_gesture(0, [&](const Clip&) { return std::move(edit); });
}

Status Document::apply_gesture(GestureId gesture, const History::MakeEdit& make_edit) {
  const ScopeExit forget([this] { forget_restored_parts(); });
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
  const ScopeExit forget([this] { forget_restored_parts(); });
  keep_gesture_ghosts(gesture);
  history_.cancel_gesture(clip_, gesture);
}

bool Document::undo() {
  const ScopeExit forget([this] { forget_restored_parts(); });
  if (const Edit* edit = history_.undo_edit()) keep_ghosts(*edit);
  return history_.undo(clip_);
}

bool Document::redo() {
  const ScopeExit forget([this] { forget_restored_parts(); });
  if (const Edit* edit = history_.redo_edit()) keep_ghosts(*edit);
  return history_.redo(clip_);
}

BvhStyle Document::style_of_frames() const {
  BvhStyle style = style_;
  if (!clip_.file_frames.empty()) style.motion = with_frames(style_.motion, clip_.file_frames);
  return style;
}

std::string Document::save_text() const { return write_bvh(clip_.skeleton, clip_.motion, style_of_frames()); }

std::string Document::save_text(const SaveOptions& options) const {
  return write_bvh(clip_.skeleton, clip_.motion, style_of_frames(), options);
}

void Document::mark_saved() {
  history_.mark_saved();
  ++save_count_;
  saved_samples_.clear();
  saved_file_frames_.reset();
  saved_skeleton_.reset();
  saved_offsets_.clear();
  saved_frame_time_s_.reset();
}

std::span<const double> Document::saved_samples(ChannelIndex channel) const {
  const auto found = saved_samples_.find(channel);
  const bool has_none = found == saved_samples_.end() || saved_file_frames_ || saved_skeleton_;
  return has_none ? std::span<const double>() : std::span<const double>(found->second);
}

void Document::forget_restored_parts() {
  if (saved_file_frames_ && clip_.file_frames == *saved_file_frames_) saved_file_frames_.reset();
  if (saved_skeleton_ && clip_.skeleton == *saved_skeleton_) saved_skeleton_.reset();
}

void Document::find_sample_changes(Changes& changes) const {
  const int frame_count = clip_.motion.frame_count();
  const std::vector<FrameIndex> present = as_listed(clip_.file_frames, frame_count);
  const std::vector<FrameIndex>& saved_frames = saved_file_frames_ ? *saved_file_frames_ : present;
  const std::vector<FrameIndex> saved_places = places_in(saved_frames, present);
  const int kept = frame_count - static_cast<int>(std::count(saved_places.begin(), saved_places.end(), -1));
  changes.removed_frames = size_of(saved_frames) - kept;
  changes.added_frames = frame_count - kept;
  if (saved_skeleton_) return;
  for (const auto& [channel, saved] : saved_samples_) {
    const std::span<const double> samples = clip_.motion.channel_samples(channel);
    const std::int64_t before = changes.samples;
    for (FrameIndex frame = 0; frame < frame_count; ++frame) {
      const FrameIndex place = saved_places[idx(frame)];
      if (place < 0 || same_bits(saved[idx(place)], samples[idx(frame)])) continue;
      ++changes.samples;
      changes.frames = hull(changes.frames, {frame, 1});
    }
    changes.channels += changes.samples > before ? 1 : 0;
  }
}

Changes Document::find_changes() const {
  Changes changes;
  find_sample_changes(changes);
  changes.figure = saved_skeleton_.has_value();
  if (!changes.figure) {
    for (const auto& [node, saved] : saved_offsets_) changes.offsets += saved != clip_.skeleton.node(node).offset ? 1 : 0;
  }
  changes.frame_time = saved_frame_time_s_ && *saved_frame_time_s_ != clip_.motion.frame_time_s();
  return changes;
}

void Document::keep_channel_ghost(ChannelIndex channel) {
  if (saved_skeleton_ || saved_samples_.contains(channel)) return;
  const std::span<const double> samples = clip_.motion.channel_samples(channel);
  saved_samples_.emplace(channel, std::vector<double>(samples.begin(), samples.end()));
}

void Document::keep_ghosts(const Edit& edit) {
  if (edit.figure && !saved_skeleton_) {
    for (ChannelIndex channel = 0; channel < clip_.motion.channel_count(); ++channel) keep_channel_ghost(channel);
    saved_skeleton_ = clip_.skeleton;
  }
  for (const SamplesChange& change : edit.samples) keep_channel_ghost(change.channel);
  if (edit.frames && !saved_file_frames_) {
    for (ChannelIndex channel = 0; channel < clip_.motion.channel_count(); ++channel) keep_channel_ghost(channel);
    saved_file_frames_ = as_listed(clip_.file_frames, clip_.motion.frame_count());
  }
  for (const OffsetChange& change : edit.offsets) {
    if (!saved_skeleton_) saved_offsets_.try_emplace(change.node, clip_.skeleton.node(change.node).offset);
  }
  if (edit.frame_time_s && !saved_frame_time_s_) saved_frame_time_s_ = clip_.motion.frame_time_s();
}

// A file saved in the middle of a gesture holds the gesture's state, which is about to be taken back.
void Document::keep_gesture_ghosts(GestureId gesture) {
  if (history_.is_in_gesture(gesture)) keep_ghosts(*history_.undo_edit());
}

std::span<const LengthUnit> known_length_units() { return kLengthUnits; }

double guess_metres_per_unit(const Skeleton& skeleton) {
  const double stature = compute_stature(skeleton);
  if (!std::isfinite(stature) || stature <= 0.0) return kDefaultMetresPerUnit;
  double best = kDefaultMetresPerUnit;
  double best_distance = std::numeric_limits<double>::infinity();
  for (const LengthUnit& candidate : kLengthUnits) {
    const double distance = std::abs(std::log(candidate.metres * stature / kHumanStatureM));
    if (distance >= best_distance) continue;
    best = candidate.metres;
    best_distance = distance;
  }
  return best;
}

}  // namespace marey
