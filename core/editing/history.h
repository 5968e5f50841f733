#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/editing/edit.h"

namespace marey {

/// Identity of a gesture (one drag, one slider held). Edits of one gesture are one step of undo. 0: no gesture.
using GestureId = std::uint64_t;

/// Undo and redo of one clip. Every change of an open clip goes through here.
class History {
 public:
  explicit History(std::size_t max_bytes = std::size_t{256} << 20) : max_bytes_(max_bytes) {}

  /// Applies an edit as a step of its own; what could be redone is forgotten. An empty edit is no step.
  void apply(Clip& clip, Edit edit);

  /// Applies one state of a gesture: the gesture's former state is taken back first, then `make_edit` sees the clip as
  /// it was before the gesture and its edit becomes the gesture's only step. An empty edit leaves no step.
  void apply_gesture(Clip& clip, GestureId gesture, const std::function<Edit(const Clip&)>& make_edit);

  /// Takes a gesture back as if it had not been (Escape during a drag). Nothing happens if it left no step on top.
  void cancel_gesture(Clip& clip, GestureId gesture);

  bool undo(Clip& clip);
  bool redo(Clip& clip);

  [[nodiscard]] int undo_depth() const { return size_of(done_); }
  [[nodiscard]] int redo_depth() const { return size_of(undone_); }
  /// Name of the step that undo (redo) would take; "" when there is none.
  [[nodiscard]] std::string undo_name() const;
  [[nodiscard]] std::string redo_name() const;

  /// Marks the present state as the saved one; is_saved() is true whenever undo or redo leads back to it.
  void mark_saved();
  [[nodiscard]] bool is_saved() const;

  /// Grows with every change of the clip, undo and redo included; never repeats. For caches.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// The step most recently applied, undone or redone touched these frames.
  [[nodiscard]] FrameRange last_changed_frames() const { return last_changed_frames_; }

  /// Drops the oldest steps while more than the bound is kept; at least the newest step stays.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  struct Step {
    Edit edit;
    GestureId gesture = 0;
    std::uint64_t state = 0;  // identity of the state that this step leads to
  };
  void push(Clip& clip, Edit edit, GestureId gesture);
  void forget_redo();
  void trim();

  std::vector<Step> done_;
  std::vector<Step> undone_;
  std::size_t max_bytes_;
  std::size_t bytes_ = 0;
  std::uint64_t revision_ = 0;
  std::uint64_t next_state_ = 1;
  std::uint64_t base_state_ = 0;
  std::uint64_t saved_state_ = 0;
  FrameRange last_changed_frames_;
};

}  // namespace marey
