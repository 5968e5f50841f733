#pragma once

#include <string>
#include <string_view>

#include "core/document/session.h"
#include "wasm/app/analysis.h"

namespace marey::app {

/// The plots over the frames of the range as a picture for print: SVG, 180 mm wide, dark lines on white whatever the theme,
/// each plot with title, unit and numbers, the letters of its components at the ends, and a line below that says what it was
/// made of. A curve with more samples than the print shows keeps its peaks.
[[nodiscard]] std::string write_plots_svg(const Session& session, const Analysis& analysis);

/// The same numbers, SI, as a table whose first lines, each behind a '#', say file, its SHA-256, filter, support, body and
/// unit of length. `file_bytes`: the clip as it would be downloaded.
[[nodiscard]] std::string write_plots_csv(const Session& session, const Analysis& analysis, std::string_view file_bytes);

/// The body that the plotted numbers rest on; null where they need none.
[[nodiscard]] const ChosenBody* body_behind(const Analysis& analysis);

/// "Frames 1 to 192 of walk.bvh; butterworth:6; ...".
[[nodiscard]] std::string describe_origin(const Session& session, const Analysis& analysis);

}  // namespace marey::app
