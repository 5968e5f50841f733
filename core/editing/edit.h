#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/motion/clip.h"

namespace marey {

/// New samples for the frames [first, first + values.size()) of one channel.
struct SamplesChange {
  ChannelIndex channel = 0;
  FrameIndex first = 0;
  std::vector<double> values;
};

/// New OFFSET of a joint or end site, file units.
struct OffsetChange {
  NodeIndex node = 0;
  glm::dvec3 offset{0.0};
};

/// The frames of `removed` give way to others, which may be none.
struct FramesChange {
  FrameRange removed;
  Motion inserted;                      ///< has the clip's channels; its frame time does not count
  std::vector<FrameIndex> file_frames;  ///< of the inserted frames, as in Clip; kNewFrame for new ones
};

/// Another figure, with all samples that move it: what changes joints, names or channels. As many frames, the same frame
/// time, the names read in the clip's character set.
struct FigureChange {
  Skeleton skeleton;
  Motion motion;
};

/// A change of a clip as a value: a name for the Edit menu ("Smooth 3 channels") and the new content of what it
/// touches, nothing else, so that the history stores deltas. Changes of one edit do not overlap; one that takes frames away
/// or brings them back changes no other samples, one of the figure changes nothing else but settings and frame time.
struct Edit {
  std::string name;
  std::vector<SamplesChange> samples;
  std::vector<OffsetChange> offsets;
  std::optional<FramesChange> frames;
  std::optional<FigureChange> figure;
  std::optional<ClipSettings> settings;
  std::optional<double> frame_time_s;
  std::optional<LayerStack> stack{};  ///< `samples` hold what comes of it: core/editing/layer_edits.h
  std::optional<BodyChoice> body{};

  [[nodiscard]] bool empty() const {
    return samples.empty() && offsets.empty() && !frames && !figure && !settings && !frame_time_s && !stack && !body;
  }
};

/// Whether `edit` fits the clip. Refused with InvalidArgument: an index or range outside of the clip, changes that
/// overlap, a unit of length that is not positive, a figure that does not fit its samples or the clip's frames, keys that are
/// no curve or of a channel that the clip does not have, masses that are none or of a joint that the figure does not have, contacts
/// that are out of order or of points or frames that there are not; with FrameTimeNotPositive or FrameTimeLooksLikeRate: what is no
/// is_frame_time(); with NotFinite: an offset that is not finite, a sample that would stop being finite (one that is not
/// finite already may stay so), and frames to insert with more such samples in a channel than those that give way.
[[nodiscard]] Status check_edit(const Clip& clip, const Edit& edit);

/// The part of `edit` that changes the clip: samples are cut to the frames from the first to the last whose bits
/// differ, everything that is the same already is dropped. Precondition: check_edit(clip, edit) is ok.
[[nodiscard]] Edit reduced_to_changes(const Clip& clip, Edit edit);

/// Exchanges the content of `edit` with that of the clip: the clip gets the new values and the edit holds the old ones,
/// so the same call undoes and redoes. Precondition: check_edit(clip, edit) is ok, or the edit came out of this call.
/// Takes memory for frames and for another character set only; where there is none, nothing is changed.
void swap_edit(Clip& clip, Edit& edit);

/// Bytes that an edit keeps, for the history's bound. Curves and samples that something else holds too do not count.
[[nodiscard]] std::size_t edit_bytes(const Edit& edit);

/// Frames whose poses an edit changes: the hull of its samples; the whole clip, as it is now, for an offset, another
/// figure, another position rule or another number of frames; none for the frame time and the other settings. But for the number of
/// frames the same before and after swap_edit().
[[nodiscard]] FrameRange edited_frames(const Clip& clip, const Edit& edit);

/// Smallest range that covers both; an empty one does not count.
[[nodiscard]] FrameRange hull(FrameRange a, FrameRange b);

}  // namespace marey
