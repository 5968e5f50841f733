#pragma once

#include "wasm/app/view_context.h"

namespace marey::app {

/// Keep the joint, frame of reference, remove: the buttons of a plot, which end at `at`.
void draw_plot_buttons(ViewContext& context, const AnalysisPlot& plot, int index, ImVec2 at);

/// The same as a menu, where there is no room for buttons: opened by a tap on the title, drawn in each frame.
void open_plot_menu();
void draw_plot_menu(ViewContext& context, const AnalysisPlot& plot, int index);

}  // namespace marey::app
