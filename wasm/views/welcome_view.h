#pragma once

#include "wasm/app/samples.h"
#include "wasm/app/view_context.h"

namespace marey::app {

/// What Marey is in one sentence, how to open a file, and the samples as moving pictures. Stands over the lower panels,
/// so that the figure above is seen playing.
class WelcomeView {
 public:
  /// `open` becomes false when it is to be closed.
  void draw(ViewContext& context, bool& open);

 private:
  void draw_head(ViewContext& context, bool& open);
  void draw_cards(ViewContext& context);
  void draw_card(ViewContext& context, const Sample& sample, ImVec2 size);
};

}  // namespace marey::app
