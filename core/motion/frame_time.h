#pragma once

namespace marey {

/// Seconds per frame from which on a BVH reader takes a frame time for frames per second. No clip has such a time, so
/// that each one can be written.
inline constexpr double kFrameTimeEndS = 10.0;

/// True for what a clip's frame time can be: more than 0 and less than kFrameTimeEndS seconds.
[[nodiscard]] constexpr bool is_frame_time(double seconds) { return seconds > 0.0 && seconds < kFrameTimeEndS; }

}  // namespace marey
