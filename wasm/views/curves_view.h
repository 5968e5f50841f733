#pragma once

#include "wasm/app/view_context.h"
#include "wasm/views/analysis/plots_view.h"
#include "wasm/views/curves/curves_drawing.h"
#include "wasm/views/curves/curves_state.h"
#include "wasm/views/curves/curves_toolbar.h"
#include "wasm/views/explorer/filter_explorer.h"
#include "wasm/views/explorer/order_view.h"

namespace marey::app {

/// The curve editor: channel list, toolbar and canvas, or in their place the filter explorer or the rotation orders. Drawn
/// into the current child window below the timeline, whose frames the curves share.
class CurvesView {
 public:
  /// `form` is that of the operation that the filter explorer looks at.
  void draw(ViewContext& context, const OperationForm& form);

  /// Call when another document has been opened: the axes are fitted anew.
  void document_opened() { state_ = {}; }

  /// Registers the commands of the curve editor. All arguments outlive the registry.
  void add_commands(CommandRegistry& registry, Session& session, ViewOptions& options, TimeWindow& time);

 private:
  void place_axes(ViewContext& context, ImVec2 origin, ImVec2 size);
  void draw_canvas(ViewContext& context);
  void draw_gutters(ViewContext& context);
  void draw_empty(ViewContext& context) const;
  void draw_curves(ViewContext& context);
  void draw_pages(ViewContext& context, ImVec2 corner, ImVec2 room) const;

  CurvesState state_;
  CurvesDrawing drawing_;
  CurvesToolbar toolbar_;
  FilterExplorer explorer_;
  OrderView orders_;
  PlotsView plots_;
};

}  // namespace marey::app
