#pragma once

#include "wasm/app/view_context.h"

namespace marey::app {

/// What was noticed while the open file was read: one entry per finding with its severity, sentence, place and count.
class ProblemsView {
 public:
  void draw(ViewContext& context);

 private:
  void draw_entry(ViewContext& context, const Diagnostic& diagnostic, int index);
};

}  // namespace marey::app
