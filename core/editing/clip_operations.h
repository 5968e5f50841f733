#pragma once

#include "core/biomechanics/body_model.h"
#include "core/editing/edit.h"

namespace marey {

/// Moves a joint or end site in the rest pose. Refused on applying if the offset is not finite.
[[nodiscard]] Edit make_offset_edit(const Clip& clip, NodeIndex node, const glm::dvec3& offset_file_units);

/// Changes the reading of the file: up axis, unit of length, meaning of the position channels,
/// character set of the names.
[[nodiscard]] Edit make_settings_edit(const Clip& clip, const ClipSettings& settings);

/// Changes what is known of the body: table, mass, gravity, segments, what joints carry.
[[nodiscard]] Edit make_body_edit(const Clip& clip, const BodyChoice& body);

/// Gives the body the masses of a model, and no others, its gravity, and its unit of length where it has one.
[[nodiscard]] Edit make_model_edit(const Clip& clip, const BodyModel& model);

/// Changes the time of a frame, so the speed of the clip; the samples stay. Refused on applying if it is no is_frame_time().
[[nodiscard]] Edit make_frame_time_edit(double frame_time_s);

/// Takes frames out of the clip; those behind them move up. `frames` lies within the clip and leaves one at least, or
/// the edit is refused on applying.
[[nodiscard]] Edit make_remove_frames_edit(FrameRange frames);

}  // namespace marey
