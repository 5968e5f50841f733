#include "wasm/app/shell.h"

namespace marey::app {

void Shell::draw_overlay(ViewContext& context, Overlay overlay, bool& open) {
  switch (overlay) {
    case Overlay::Palette: palette_.draw(context, open); break;
    case Overlay::Shortcuts: shortcut_sheet_.draw(context, open); break;
    case Overlay::About: about_.draw(context, open); break;
    case Overlay::Welcome: welcome_.draw(context, open); break;
    case Overlay::SaveAs: save_as_.draw(context, open); break;
    case Overlay::None: break;
  }
}

void Shell::draw_overlays(ViewContext& context, Workspace& workspace) {
  const Overlay drawn = workspace.overlay;
  if (drawn == Overlay::None) return;
  bool open = true;
  if (const std::optional<Fault> fault = draw_guarded([&] { draw_overlay(context, drawn, open); })) {
    open = false;
    const Message message{MessageKind::Error, "The window could not be shown", fault->details + ". Your file is as it was.", ""};
    workspace.backend.report_fault(message.title + ": " + message.detail);
    workspace.backend.announce(message.title + ". " + message.detail);
    workspace.messages.add(message);
    context.redraw = true;
  }
  // A command that ran from the window may have opened another one.
  if (open || workspace.overlay != drawn) return;
  workspace.overlay = Overlay::None;
  workspace.preferences.welcome_seen = true;
}

}  // namespace marey::app
