#pragma once

#include <vector>

#include "wasm/app/view_context.h"
#include "wasm/app/widgets.h"

namespace marey::app {

/// The row of playback controls: first, previous, play, next, last, loop, speed, frame and time.
class TransportView {
 public:
  static constexpr float kHeight = 40.0f;
  void draw(ViewContext& context);

 private:
  void follow_speed(double speed);
  void draw_buttons(ViewContext& context);
  void draw_speed(ViewContext& context);
  void draw_position(ViewContext& context);

  std::vector<double> speeds_;  ///< the usual ones and the present one
  std::vector<ui::ChoiceOption> speed_options_;
  int present_speed_ = -1;
};

}  // namespace marey::app
