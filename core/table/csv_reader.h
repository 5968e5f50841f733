#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/bvh/bvh_clip.h"
#include "core/bvh/limits.h"

namespace marey {

// Tables as core/table/csv.h writes them, and as other programs do: commas, semicolons or tabs between the fields,
// decimal points, or commas where the separator is another; quotes, a byte order mark, any line ends, blank lines,
// lines of notes that begin with '#' before the header. A name may be followed by its unit: "time [s]", "Hips.x[cm]";
// [deg], [s] and units of length are known, and no value is converted. The column "frame" is not used.
// What is assumed is a diagnostic with its place; what cannot be used is an Error with line and column.

struct TableOptions {
  bool strict = false;  ///< refuse what would be repaired, as the reader of BVH does
  ReadLimits limits;
};

/// Motion for a figure. Columns are found by their names, "Hips.Xposition", in any order; the k-th column of a name is the
/// k-th channel of that name. Channels without a column keep the value of the figure's first frame, 0 where it has none.
/// Hierarchy, style and rule of positions are those of `figure`. A table written by append_channel_rows() gives back
/// the bits of all samples and, from two rows on, of the frame time.
/// Errors: no column fits, uneven times, a field that is no number, a row of another length, limits.
[[nodiscard]] Result<BvhClip> read_channel_table(std::string_view text, const BvhClip& figure,
                                                 const TableOptions& options = {});

/// Points in space, "Hips.x,Hips.y,Hips.z": each becomes a root with position channels, of the axes that it has, in the
/// order of the columns. A table written by append_position_rows() comes out of append_position_rows() the same, byte
/// for byte, from two rows on.
/// Errors: no column ends in .x, .y or .z; the table has channels, which need a figure; as above.
[[nodiscard]] Result<BvhClip> read_points_table(std::string_view text, const TableOptions& options = {});

}  // namespace marey
