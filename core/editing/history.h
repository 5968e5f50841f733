#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <string_view>
#include <vector>

#include "core/editing/edit.h"

namespace marey {

/// Identity of a gesture (one drag, one slider held). Edits of one gesture are one step of undo. 0: no gesture.
using GestureId = std::uint64_t;

/// Undo and redo of one clip. Every change of an open clip goes through here. Where there is no memory for a call
/// (std::bad_alloc), clip and history are as before it.
class History {
 public:
  using MakeEdit = std::function<Edit(const Clip&)>;

  explicit History(std::size_t max_bytes = std::size_t{256} << 20) : max_bytes_(max_bytes) {}

  /// Applies an edit as a step of its own; what could be redone is forgotten. An edit that changes nothing is no step
  /// and forgets nothing. An edit that check_edit() refuses changes nothing.
  Status apply(Clip& clip, Edit edit);

  /// Applies one state of a gesture: the gesture's former state is taken back first, then `make_edit` sees the clip as
  /// it was before the gesture and its edit becomes the gesture's only step. An edit that changes nothing leaves no
  /// step, and what could be redone before the gesture can be redone again. If check_edit() refuses the edit, the
  /// gesture stays in its former state. A gesture is over when another step is applied, or when it is undone.
  /// Gesture 0 is apply().
  Status apply_gesture(Clip& clip, GestureId gesture, const MakeEdit& make_edit);

  /// Takes a gesture back as if it had not been (Escape during a drag). Nothing happens if it left no step on top.
  void cancel_gesture(Clip& clip, GestureId gesture);

  bool undo(Clip& clip);
  bool redo(Clip& clip);

  [[nodiscard]] int undo_depth() const { return size_of(done_); }
  [[nodiscard]] int redo_depth() const { return size_of(undone_); }
  /// Name of the step that undo (redo) would take; "" when there is none.
  [[nodiscard]] std::string_view undo_name() const;
  [[nodiscard]] std::string_view redo_name() const;
  /// What undo (redo) would swap into the clip; nullptr when there is nothing to undo (redo).
  [[nodiscard]] const Edit* undo_edit() const { return done_.empty() ? nullptr : &done_.back().edit; }
  [[nodiscard]] const Edit* redo_edit() const { return undone_.empty() ? nullptr : &undone_.back().edit; }
  /// Whether the newest step is the state of this gesture, so that apply_gesture() would replace it.
  [[nodiscard]] bool is_in_gesture(GestureId gesture) const;

  /// Marks the present state as the saved one; is_saved() is true whenever undo or redo leads back to it. A new
  /// history is saved.
  void mark_saved() { saved_state_ = present_state(); }
  [[nodiscard]] bool is_saved() const { return saved_state_ == present_state(); }

  /// Grows by one with every change of the clip, undo and redo included; never repeats. For caches.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// The frames that the change to the present revision touched; a cache of the revision before needs only these.
  [[nodiscard]] FrameRange last_changed_frames() const { return changed_frames_[idx(last_change())]; }
  /// The same for a cache of an earlier revision; all frames that a clip can have if that was too long ago.
  [[nodiscard]] FrameRange changed_frames_since(std::uint64_t revision) const;

  /// Bytes kept for undo and redo. Beyond the bound the oldest steps are dropped; at least the newest stays.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  struct Step {
    Edit edit;
    GestureId gesture = 0;    // on the newest step only, and then nothing can be redone
    std::uint64_t state = 0;  // identity of the state that this step leads to
    std::size_t bytes = 0;    // as counted in bytes_: an edit of frames holds less while it is undone
  };
  [[nodiscard]] std::uint64_t present_state() const { return done_.empty() ? base_state_ : done_.back().state; }
  void push(Clip& clip, Edit edit, GestureId gesture);
  void replace_newest(const Clip& clip, Edit edit, FrameRange former_frames);
  void drop_newest();
  void forget(std::vector<Step>& steps);
  void trim();
  void note_change(FrameRange frames);
  [[nodiscard]] int last_change() const { return static_cast<int>(revision_ % kChangesKept); }

  static constexpr std::uint64_t kChangesKept = 16;

  std::deque<Step> done_;
  std::vector<Step> undone_;
  std::vector<Step> undone_before_gesture_;  // what cancelling the gesture on top gives back
  std::size_t max_bytes_;
  std::size_t bytes_ = 0;
  std::uint64_t revision_ = 0;
  std::uint64_t next_state_ = 1;
  std::uint64_t base_state_ = 0;
  std::uint64_t saved_state_ = 0;
  std::array<FrameRange, kChangesKept> changed_frames_;  // of a revision at its remainder
};

}  // namespace marey
