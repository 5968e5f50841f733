#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/text_excerpt.h"
#include "core/document/document.h"
#include "core/document/playback.h"
#include "core/document/selection.h"
#include "core/editing/key_edits.h"

namespace marey {

/// A clip beside the open one, for operations that take another and to compare with.
struct OtherClip {
  std::string file_name;
  Clip clip;
};

/// More are not told apart in a plot.
inline constexpr int kMostOtherClips = 4;

/// An open clip with what the user has selected and where they look. Edits go through here rather than through
/// `document`, so that playback follows the clip.
struct Session {
  Document document;
  Selection selection;
  Playback playback;
  std::vector<TextExcerpt> excerpts;  ///< of each of the document's diagnostics, in the bytes of the file

  /// The layer that keys are set on; kOwnKeys for the keys of the channels themselves. Always one that the clip has.
  int active_layer = kOwnKeys;

  std::vector<std::shared_ptr<const OtherClip>> others;  ///< in the order in which they were read, at most kMostOtherClips
  std::uint64_t others_serial = 0;                       ///< grows with each change of them

  /// More of the file is still to come: every edit is refused.
  bool is_partial = false;

  /// The one that was read last, which operations take; null: none was read.
  [[nodiscard]] std::shared_ptr<const OtherClip> other() const { return others.empty() ? nullptr : others.back(); }
  /// The first one gives way to one too many.
  void put_beside(std::shared_ptr<const OtherClip> other);
  void take_away(int other);

  /// Nothing selected, paused on the first frame.
  [[nodiscard]] static Session open(BvhClip clip, std::string file_name);

  /// As in Document.
  Status apply(Edit edit);
  Status apply_gesture(GestureId gesture, const History::MakeEdit& make_edit);
  void cancel_gesture(GestureId gesture);
  bool undo();
  bool redo();
};

}  // namespace marey
