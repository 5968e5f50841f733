#pragma once

#include "wasm/app/view_context.h"

namespace marey::app {

/// The row of playback controls: first, previous, play, next, last, loop, speed, frame and time.
class TransportView {
 public:
  static constexpr float kHeight = 40.0f;
  void draw(ViewContext& context);

 private:
  void draw_buttons(ViewContext& context);
  void draw_speed(ViewContext& context);
  void draw_position(ViewContext& context);
};

}  // namespace marey::app
