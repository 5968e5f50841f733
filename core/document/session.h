#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/text_excerpt.h"
#include "core/document/document.h"
#include "core/document/playback.h"
#include "core/document/selection.h"
#include "core/editing/key_edits.h"

namespace marey {

/// A clip beside the open one, for operations that take another.
struct OtherClip {
  std::string file_name;
  Clip clip;
};

/// An open clip with what the user has selected and where they look. Edits go through here rather than through
/// `document`, so that playback follows the clip.
struct Session {
  Document document;
  Selection selection;
  Playback playback;
  std::vector<TextExcerpt> excerpts;  ///< of each of the document's diagnostics, in the bytes of the file

  /// The layer that keys are set on; kOwnKeys for the keys of the channels themselves. Always one that the clip has.
  int active_layer = kOwnKeys;

  std::shared_ptr<const OtherClip> other;  ///< null: none was read

  /// More of the file is still to come: every edit is refused.
  bool is_partial = false;

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
