#pragma once

#include "wasm/app/view_context.h"

namespace marey::app {

/// The uppermost row: name of the program and of the file, menus, search for commands, undo, redo, download. On a narrow
/// page the menus stand behind one button.
class TitleBar {
 public:
  void draw(ViewContext& context, bool compact);

 private:
  void draw_wide(ViewContext& context);
  void draw_compact(ViewContext& context);
  void draw_menus(ViewContext& context);
  void draw_menu_button(ViewContext& context, int menu);
  void follow_menu_keys();

  int open_menu_ = -1;
  int wanted_menu_ = -1;  ///< to be opened in this frame, by an arrow key
};

}  // namespace marey::app
