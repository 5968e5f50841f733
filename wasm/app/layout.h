#pragma once

#include <imgui.h>

#include "wasm/app/preferences.h"

namespace marey::app {

/// Rectangle in ImGui units; empty (no area) for a region that is not shown.
struct Region {
  ImVec2 min;
  ImVec2 max;
  [[nodiscard]] float width() const { return max.x - min.x; }
  [[nodiscard]] float height() const { return max.y - min.y; }
  [[nodiscard]] bool empty() const { return width() <= 0.0f || height() <= 0.0f; }
};

/// Where everything stands. Regions never overlap and fill the window; a panel that is opening or closing keeps its full
/// size and reaches out of the window.
///
///     wide:                                     compact (narrower than kCompactWidth):
///     title                                     title
///     messages                                  messages
///     outliner | viewport | inspector           viewport
///     transport                                 transport
///     ruler                                     sheet header (tabs)
///     curves                                    ruler + curves, outliner or inspector
struct Layout {
  bool compact = false;
  Region title;
  Region messages;
  Region outliner;
  Region viewport;
  Region inspector;
  Region transport;
  Region sheet_header;
  Region ruler;
  Region curves;
};

inline constexpr float kCompactWidth = 700.0f;

struct LayoutInput {
  ImVec2 size;              ///< of the window, ImGui units
  float messages_height = 0.0f;
  bool touch = false;
  /// How far the panels are open, 0..1; between the two while one opens or closes.
  float outliner_share = 1.0f;
  float inspector_share = 1.0f;
  float curves_share = 1.0f;
  const Preferences* preferences = nullptr;
};

/// The measures of look and feel; panels shrink before the viewport vanishes. A wide page shows the panels by their
/// shares, a narrow one the sheet of the preferences.
[[nodiscard]] Layout compute_layout(const LayoutInput& input);

/// The bounds that a splitter keeps to in a window of `size`.
struct SplitterLimits {
  float low = 0.0f;
  float high = 0.0f;
};
[[nodiscard]] SplitterLimits outliner_limits(ImVec2 size);
[[nodiscard]] SplitterLimits inspector_limits(ImVec2 size);
[[nodiscard]] SplitterLimits curves_limits(ImVec2 size);

}  // namespace marey::app
