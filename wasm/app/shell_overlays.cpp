#include "wasm/app/shell.h"

namespace marey::app {

void Shell::draw_overlays(ViewContext& context, Workspace& workspace) {
  const Overlay drawn = workspace.overlay;
  bool open = drawn != Overlay::None;
  switch (drawn) {
    case Overlay::Palette: palette_.draw(context, open); break;
    case Overlay::Shortcuts: shortcut_sheet_.draw(context, open); break;
    case Overlay::About: about_.draw(context, open); break;
    case Overlay::Welcome: welcome_.draw(context, open); break;
    case Overlay::SaveAs: save_as_.draw(context, open); break;
    case Overlay::None: return;
  }
  // A command that ran from the window may have opened another one.
  if (open || workspace.overlay != drawn) return;
  workspace.overlay = Overlay::None;
  workspace.preferences.welcome_seen = true;
}

}  // namespace marey::app
