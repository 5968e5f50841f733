#pragma once

#include "wasm/app/view_context.h"
#include "wasm/views/problems/choice_cards.h"
#include "wasm/views/problems/pose_picture.h"

namespace marey::app {

/// The alternatives where a file can be read in several ways: cards that show what would come of each, one click, undoable.
class ReadingChoices {
 public:
  /// What belongs below a finding of this code; false if that is nothing.
  bool draw_below(ViewContext& context, DiagnosticCode code);
  /// Whether the first frame is part of the movement.
  void draw_first_frame(ViewContext& context);
  /// What no file says and every file leaves to be guessed: up axis, unit of length, frame rate.
  void draw_assumptions(ViewContext& context);

 private:
  ChoiceCard pictured(ViewContext& context, const char* command_id, const ClipSettings& settings);
  ChoiceCard frame_card(ViewContext& context, const char* command_id, FrameIndex shown);
  void draw_positions(ViewContext& context);
  void draw_frame_rate(ViewContext& context);
  void draw_unit(ViewContext& context);
  void draw_surplus_frames(ViewContext& context);

  PosePicture picture_;
};

}  // namespace marey::app
