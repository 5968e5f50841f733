#pragma once

#include "wasm/app/layout.h"
#include "wasm/app/panel_guards.h"
#include "wasm/app/transition.h"
#include "wasm/app/view_context.h"
#include "wasm/app/workspace.h"
#include "wasm/render/scene.h"
#include "wasm/views/about_view.h"
#include "wasm/views/command_palette.h"
#include "wasm/views/curves_view.h"
#include "wasm/views/inspector_view.h"
#include "wasm/views/loading_strip.h"
#include "wasm/views/message_strip.h"
#include "wasm/views/outliner_view.h"
#include "wasm/views/save_as_view.h"
#include "wasm/views/shortcut_sheet.h"
#include "wasm/views/timeline_view.h"
#include "wasm/views/title_bar.h"
#include "wasm/views/transport_view.h"
#include "wasm/views/viewport_view.h"
#include "wasm/views/welcome_view.h"

namespace marey::app {

/// The window around the views: holds them, gives each its region, moves the splitters between them.
class Shell {
 public:
  void draw(ViewContext& context, Workspace& workspace, Scene& scene);
  /// The windows above the panels: palette, shortcut sheet, about, samples.
  void draw_overlays(ViewContext& context, Workspace& workspace);

  /// Call when another document has been opened.
  void document_opened();
  void add_commands(CommandRegistry& registry, Workspace& workspace, TimeWindow& time_window);

 private:
  void draw_bars(ViewContext& context, Workspace& workspace, const Layout& layout);
  void draw_strips(ViewContext& context, Workspace& workspace, const Region& region);
  void draw_side_panels(ViewContext& context, const Layout& layout);
  void draw_time_panels(ViewContext& context, const Layout& layout);
  void draw_overlay(ViewContext& context, Overlay overlay, bool& open);
  void tell_faults(Workspace& workspace);

  Layout lay_out(ViewContext& context, Workspace& workspace);

  PanelGuards guards_;
  Transition outliner_opening_;
  Transition inspector_opening_;
  Transition curves_opening_;
  TitleBar title_bar_;
  LoadingStrip loading_strip_;
  MessageStrip message_strip_;
  OutlinerView outliner_;
  InspectorView inspector_;
  TransportView transport_;
  TimelineView timeline_;
  CurvesView curves_;
  ViewportView viewport_;
  CommandPalette palette_;
  ShortcutSheet shortcut_sheet_;
  AboutView about_;
  WelcomeView welcome_;
  SaveAsView save_as_;
};

}  // namespace marey::app
