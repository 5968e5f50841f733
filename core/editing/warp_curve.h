#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace marey {

/// A point of a warp: the frame of the clip that comes to another place, both counted from 0.
struct WarpPoint {
  double from = 0.0;
  double to = 0.0;
};

/// Reads "1:1,50:80,100:120": frames counted from 1, rising on both sides. Error InvalidArgument names the wrong part.
[[nodiscard]] Result<std::vector<WarpPoint>> parse_warp_points(std::string_view text);

/// For each new frame the place in the clip that it shows, of a clip with so many frames (>= 1): the monotone cubic through
/// the points (Fritsch and Carlson 1980), so time never runs backwards and never overshoots. Before the first and behind the
/// last point time goes on at its own speed. `points` rise on both sides, or are none.
/// Error InvalidArgument: more than `most` new frames.
[[nodiscard]] Result<std::vector<double>> make_warped_times(std::vector<WarpPoint> points, int frame_count, double most);

}  // namespace marey
