#pragma once

#include "wasm/app/messages.h"
#include "wasm/app/view_context.h"

namespace marey::app {

/// The newest unread message over the full width, below the title bar: what happened, where and what to do. It stays
/// until it is closed; further ones are counted.
class MessageStrip {
 public:
  /// Height that draw() needs in a window of this width; 0 when there is nothing to read.
  [[nodiscard]] float height(const ViewContext& context, const Messages& messages, float width) const;
  void draw(ViewContext& context, Messages& messages);
};

}  // namespace marey::app
