#pragma once

#include <span>
#include <vector>

#include "core/editing/operation.h"

namespace marey {

/// The edit in which some frames give way to others.
[[nodiscard]] Edit make_frames_edit(const OperationCall& call, FrameRange removed, Motion inserted,
                                    std::vector<FrameIndex> file_frames);

/// The edit in which the frames of `removed` give way to the movement at other times, counted in frames of the clip with
/// fraction. A time that is a frame keeps it, samples and file frame. Error InvalidArgument: more samples than
/// kMaxResampledSamples.
[[nodiscard]] Result<OperationOutcome> make_retimed_edit(const OperationCall& call, FrameRange removed,
                                                         std::span<const double> times);

/// The file frame of each time that is a frame, once at most and rising; kNewFrame for the others.
[[nodiscard]] std::vector<FrameIndex> kept_file_frames(const Clip& clip, std::span<const double> times);

/// Clip::file_frames of a range with nothing left to be understood.
[[nodiscard]] std::vector<FrameIndex> file_frames_of(const Clip& clip, FrameRange frames);

}  // namespace marey
