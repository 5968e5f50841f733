#pragma once

#include <vector>

#include "wasm/app/view_context.h"
#include "wasm/app/workspace.h"
#include "wasm/views/analysis/contact_strip.h"
#include "wasm/views/analysis/plot_row.h"

namespace marey::app {

/// The panel of quantities below the timeline: contacts and rows over time under the ruler, or each against the first, or the statistics
/// of the range. On the left of each row stands what it is, of whom, and its values at the cursor.
class PlotsView {
 public:
  void draw(ViewContext& context, ImVec2 min, ImVec2 max, float pages_width);

 private:
  void draw_toolbar(ViewContext& context, ImVec2 min, float width);
  void draw_add(ViewContext& context);
  void draw_rows(ViewContext& context, ImVec2 min, ImVec2 max);
  void draw_label(ViewContext& context, const AnalysisPlot& plot, int index, ImVec2 min, ImVec2 max);
  void draw_narrow_label(ViewContext& context, const AnalysisPlot& plot, int index, ImVec2 min, ImVec2 max) const;
  void draw_values(ViewContext& context, const AnalysisPlot& plot, int index, ImVec2 at, ImVec2 max) const;
  void draw_against(ViewContext& context, ImVec2 min, ImVec2 max) const;

  ContactStrip contacts_;
  std::vector<PlotRow> rows_;
};

/// Brings what is analysed up to date with the clip; for each panel that shows something of it, before it draws.
void follow_analysis(ViewContext& context);

/// The table of lowest and highest values with their times, means and root mean squares over the range of playback.
void draw_statistics(ViewContext& context, ImVec2 min, ImVec2 max);

/// The list of quantities as an open popup; returns the chosen one in the frame of the click.
[[nodiscard]] const Quantity* draw_quantity_list(ViewContext& context, const char* popup);

/// Commands of the panel, of its downloads and of the arrows. The workspace outlives the registry.
void add_analysis_commands(CommandRegistry& registry, Workspace& workspace);

}  // namespace marey::app
