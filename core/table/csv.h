#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/motion.h"
#include "core/skeleton/position_rule.h"
#include "core/skeleton/skeleton.h"

namespace marey {

// Clips as comma-separated tables for spreadsheets and scripts: one header line, one line per frame, '.' as the decimal
// point, "\n" as the line end. The first two columns are `frame`, counted from 1, and `time` in seconds, 0 in the first
// frame. A number is the shortest text that reads back as the same double. A name that holds a comma, a quote or a line
// break stands in quotes. Rows are appended for a range of frames, so that long clips can be written piece by piece.

/// "Hips.Xposition": the name of a channel's column.
[[nodiscard]] std::string channel_column_name(const Skeleton& skeleton, ChannelIndex channel);

/// "frame,time,Hips.Xposition,Hips.Yposition,...": the columns of a BVH file. With a unit of length the names carry
/// units: "frame,time[s],Hips.Xposition[cm],Hips.Zrotation[deg],...".
void append_channel_header(const Skeleton& skeleton, std::string& out, std::string_view length_unit = {});
/// Samples in degrees and file units. `frames` lies within the motion.
void append_channel_rows(const Motion& motion, FrameRange frames, std::string& out);

/// "frame,time,Hips.x,Hips.y,Hips.z,...": joints in file order, an end site as "<joint>_end" behind its joint.
/// With a unit of length: "frame,time[s],Hips.x[cm],...".
void append_position_header(const Skeleton& skeleton, std::string& out, std::string_view length_unit = {});
/// World positions in file units. `frames` lies within the motion.
void append_position_rows(const Skeleton& skeleton, const Motion& motion, FrameRange frames, PositionRule rule,
                          std::string& out);

/// A column of any table over the frames.
struct NumberColumn {
  std::string_view name;           ///< "torque:Body.x[N.m]"
  std::span<const double> values;  ///< one per frame; one that is not finite stands as an empty field
};

/// "frame,time[s],torque:Body.x[N.m],...": units stand in the names.
void append_columns_header(std::span<const NumberColumn> columns, std::string& out);
/// Frames are `frame_time_s` apart. `frames` lies within the columns.
void append_columns(std::span<const NumberColumn> columns, double frame_time_s, FrameRange frames, std::string& out);

}  // namespace marey
