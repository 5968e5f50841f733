#pragma once

#include "wasm/app/view_context.h"

namespace marey::app {

/// Every shortcut, by group, made from the command registry.
class ShortcutSheet {
 public:
  /// `open` becomes false when it is to be closed.
  void draw(ViewContext& context, bool& open);
};

}  // namespace marey::app
