#pragma once

#include "wasm/app/view_context.h"
#include "wasm/views/curves/curves_drawing.h"
#include "wasm/views/curves/curves_state.h"
#include "wasm/views/curves/curves_toolbar.h"

namespace marey::app {

/// The curve editor: channel list, toolbar and canvas. Drawn into the current child window below the timeline, whose
/// frames it shares.
class CurvesView {
 public:
  void draw(ViewContext& context);

  /// Call when another document has been opened: the axes are fitted anew.
  void document_opened() { state_ = {}; }

  /// Registers the commands of the curve editor. All arguments outlive the registry.
  void add_commands(CommandRegistry& registry, Session& session, ViewOptions& options, TimeWindow& time);

 private:
  void place_axes(ViewContext& context, ImVec2 origin, ImVec2 size);
  void draw_canvas(ViewContext& context);
  void draw_gutters(ViewContext& context);
  void draw_empty(ViewContext& context) const;

  CurvesState state_;
  CurvesDrawing drawing_;
  CurvesToolbar toolbar_;
};

}  // namespace marey::app
