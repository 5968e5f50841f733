#include "core/editing/history.h"

#include <limits>
#include <utility>

#include "core/base/scope_exit.h"
#include "core/editing/contact_edits.h"
#include "core/editing/layer_edits.h"

namespace marey {
namespace {

// What of an edit is to be swapped into the clip.
Result<Edit> prepare(const Clip& clip, Edit edit) {
  if (Status status = check_edit(clip, edit); !status) return status.error();
  Result<Edit> fitting = fit_to_layers(clip, carry_contacts(clip, reduced_to_changes(clip, std::move(edit))));
  if (!fitting) return fitting;
  return fitting->stack ? reduced_to_changes(clip, std::move(*fitting)) : std::move(*fitting);
}

}  // namespace

Status History::apply(Clip& clip, Edit edit) {
  Result<Edit> prepared = prepare(clip, std::move(edit));
  if (!prepared) return prepared.error();
  if (!prepared->empty()) push(clip, std::move(*prepared), 0);
  return {};
}

Status History::apply_gesture(Clip& clip, GestureId gesture, const MakeEdit& make_edit) {
  if (!is_in_gesture(gesture)) {
    Result<Edit> edit = prepare(clip, make_edit(clip));
    if (!edit) return edit.error();
    if (!edit->empty()) push(clip, std::move(*edit), gesture);
    return {};
  }
  const FrameRange former_frames = edited_frames(clip, done_.back().edit);
  swap_edit(clip, done_.back().edit);
  ScopeExit stay([&] { swap_edit(clip, done_.back().edit); });
  Result<Edit> prepared = prepare(clip, make_edit(clip));
  if (!prepared) return prepared.error();
  Edit& edit = *prepared;
  if (edit.empty()) {
    stay.dismiss();
    drop_newest();
    note_change(former_frames);
    return {};
  }
  swap_edit(clip, edit);
  stay.dismiss();
  replace_newest(clip, std::move(edit), former_frames);
  return {};
}

void History::cancel_gesture(Clip& clip, GestureId gesture) {
  if (!is_in_gesture(gesture)) return;
  const FrameRange frames = edited_frames(clip, done_.back().edit);
  swap_edit(clip, done_.back().edit);
  drop_newest();
  note_change(frames);
}

bool History::undo(Clip& clip) {
  if (done_.empty()) return false;
  undone_.emplace_back();
  ScopeExit give_up([&] { undone_.pop_back(); });
  swap_edit(clip, done_.back().edit);
  give_up.dismiss();
  undone_.back() = std::move(done_.back());
  undone_.back().gesture = 0;
  done_.pop_back();
  forget(undone_before_gesture_);
  note_change(edited_frames(clip, undone_.back().edit));
  return true;
}

bool History::redo(Clip& clip) {
  if (undone_.empty()) return false;
  done_.emplace_back();
  ScopeExit give_up([&] { done_.pop_back(); });
  swap_edit(clip, undone_.back().edit);
  give_up.dismiss();
  done_.back() = std::move(undone_.back());
  undone_.pop_back();
  note_change(edited_frames(clip, done_.back().edit));
  return true;
}

FrameRange History::changed_frames_since(std::uint64_t revision) const {
  if (revision > revision_ || revision_ - revision > kChangesKept) return {0, std::numeric_limits<int>::max()};
  FrameRange frames;
  for (std::uint64_t later = revision + 1; later <= revision_; ++later) {
    frames = hull(frames, changed_frames_[later % kChangesKept]);
  }
  return frames;
}

std::string_view History::undo_name() const { return done_.empty() ? std::string_view() : done_.back().edit.name; }

std::string_view History::redo_name() const { return undone_.empty() ? std::string_view() : undone_.back().edit.name; }

bool History::is_in_gesture(GestureId gesture) const {
  return gesture != 0 && !done_.empty() && done_.back().gesture == gesture;
}

void History::push(Clip& clip, Edit edit, GestureId gesture) {
  done_.emplace_back();
  ScopeExit give_up([&] { done_.pop_back(); });
  swap_edit(clip, edit);
  give_up.dismiss();
  forget(undone_before_gesture_);
  if (gesture != 0) {
    undone_before_gesture_.swap(undone_);
  } else {
    forget(undone_);
  }
  if (done_.size() > 1) done_[done_.size() - 2].gesture = 0;
  note_change(edited_frames(clip, edit));
  const std::size_t bytes = edit_bytes(edit);
  bytes_ += bytes;
  done_.back() = {std::move(edit), gesture, next_state_++, bytes};
  trim();
}

// For a gesture, whose former edit has been swapped out of the clip and whose next one into it.
void History::replace_newest(const Clip& clip, Edit edit, FrameRange former_frames) {
  const std::size_t bytes = edit_bytes(edit);
  bytes_ += bytes - done_.back().bytes;
  note_change(hull(former_frames, edited_frames(clip, edit)));
  done_.back() = {std::move(edit), done_.back().gesture, next_state_++, bytes};
  trim();
}

// For a gesture's step, whose edit has been swapped out of the clip: nothing can be redone behind it.
void History::drop_newest() {
  bytes_ -= done_.back().bytes;
  done_.pop_back();
  undone_.swap(undone_before_gesture_);
}

void History::forget(std::vector<Step>& steps) {
  for (const Step& step : steps) bytes_ -= step.bytes;
  steps.clear();
}

void History::trim() {
  if (bytes_ > max_bytes_) forget(undone_before_gesture_);
  while (bytes_ > max_bytes_ && done_.size() > 1) {
    bytes_ -= done_.front().bytes;
    base_state_ = done_.front().state;
    done_.pop_front();
  }
}

void History::note_change(FrameRange frames) {
  ++revision_;
  changed_frames_[idx(last_change())] = frames;
}

}  // namespace marey
