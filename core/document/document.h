#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/bvh/bvh_clip.h"
#include "core/bvh/save_options.h"
#include "core/document/changes.h"
#include "core/editing/history.h"

namespace marey {

/// An open clip: the only mutable thing of the program. It changes by named edits alone.
class Document {
 public:
  Document() = default;
  /// Opens what a reader returned, and guesses up axis and metres per unit. `file_name` is what was opened,
  /// "walk.bvh".
  Document(BvhClip clip, std::string file_name);

  [[nodiscard]] const Clip& clip() const { return clip_; }
  [[nodiscard]] const Skeleton& skeleton() const { return clip_.skeleton; }
  [[nodiscard]] const Motion& motion() const { return clip_.motion; }
  [[nodiscard]] const ClipSettings& settings() const { return clip_.settings; }
  /// What was noticed on opening, as valid UTF-8; names in it are read as settings().names_in says.
  [[nodiscard]] const Diagnostics& diagnostics() const;
  [[nodiscard]] const BvhStyle& style() const { return style_; }
  /// As in BvhClip: less than the frames of the opened file, or 0.
  [[nodiscard]] int declared_frames() const { return declared_frames_; }
  [[nodiscard]] const std::string& file_name() const { return file_name_; }
  [[nodiscard]] const History& history() const { return history_; }

  /// As in History: an edit that does not fit the clip is refused and changes nothing, nor does one without memory for it.
  Status apply(Edit edit);
  /// One state of a gesture (one drag): as in History. The caller gives each gesture an id of its own.
  Status apply_gesture(GestureId gesture, const History::MakeEdit& make_edit);
  void cancel_gesture(GestureId gesture);
  bool undo();
  bool redo();

  [[nodiscard]] bool is_dirty() const { return !history_.is_saved(); }
  /// Grows with every change; for caches of derived data.
  [[nodiscard]] std::uint64_t revision() const { return history_.revision(); }

  /// The clip as a BVH file in the opened file's style.
  [[nodiscard]] std::string save_text() const;
  /// The same but for what `options` ask; its frames lie within the clip.
  [[nodiscard]] std::string save_text(const SaveOptions& options) const;
  /// Call when the text has reached the user. The ghosts are forgotten.
  void mark_saved();
  /// How often mark_saved() was called; for caches of what is derived from the ghosts.
  [[nodiscard]] std::uint64_t save_count() const { return save_count_; }

  /// The samples of a channel as last opened or saved, for the ghost curve; empty while the channel is untouched, while
  /// frames are missing that were there, and while the figure is another one.
  [[nodiscard]] std::span<const double> saved_samples(ChannelIndex channel) const;
  /// In what a download would differ from what was last opened or saved. Looks at every sample of the touched channels.
  [[nodiscard]] Changes find_changes() const;

 private:
  [[nodiscard]] BvhStyle style_of_frames() const;
  void keep_ghosts(const Edit& edit);
  void keep_gesture_ghosts(GestureId gesture);
  void keep_channel_ghost(ChannelIndex channel);
  void forget_restored_parts();
  void find_sample_changes(Changes& changes) const;

  Clip clip_;
  BvhStyle style_;
  Diagnostics diagnostics_;  // as the reader wrote them
  mutable Diagnostics readable_diagnostics_;
  mutable std::optional<CharacterSet> readable_in_;
  std::string file_name_;
  int declared_frames_ = 0;
  History history_;
  std::uint64_t save_count_ = 0;
  std::map<ChannelIndex, std::vector<double>> saved_samples_;
  std::optional<std::vector<FrameIndex>> saved_file_frames_;  // as Clip::file_frames; nothing while all are there
  std::optional<Skeleton> saved_skeleton_;  // while the figure is another one; the ghosts are then by its channels and nodes
  std::map<NodeIndex, glm::dvec3> saved_offsets_;
  std::optional<double> saved_frame_time_s_;
};

/// A length that files are made in.
struct LengthUnit {
  std::string_view name;  ///< for people: "cm"
  double metres = 1.0;
};

/// Those that guess_metres_per_unit() chooses from.
[[nodiscard]] std::span<const LengthUnit> known_length_units();

/// The length of a file unit that makes the figure's stature human: 1 m, 1 cm, 1 mm, 1 inch or the CMU unit
/// (0.0254 / 0.45 m = 5.644 cm), whichever brings the stature nearest to 1.7 m as a ratio. 1 cm without a stature.
[[nodiscard]] double guess_metres_per_unit(const Skeleton& skeleton);

/// The clip of a file with the settings that are guessed for it.
[[nodiscard]] Clip make_clip(BvhClip clip);

}  // namespace marey
