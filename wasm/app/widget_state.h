#pragma once

#include <imgui.h>

#include <string>

#include "core/editing/history.h"

namespace marey::app {

/// What a control must remember between frames. One pointer and one keyboard: one number field at a time.
struct WidgetState {
  ImGuiID number_id = 0;        ///< the field that is dragged, stepped or typed in; 0: none
  bool number_typing = false;
  int number_typing_frames = 0;
  std::string number_text;      ///< as typed
  double number_start = 0.0;    ///< value at the begin of the drag
  double number_dragged = 0.0;  ///< moved since then, in steps
  GestureId number_gesture = 0;
  ImGuiID number_step_id = 0;   ///< the field that arrow keys step; its steps share number_gesture
  GestureId last_gesture = 0;

  /// Identity for a drag that begins; never repeats.
  GestureId new_gesture() { return ++last_gesture; }
};

}  // namespace marey::app
