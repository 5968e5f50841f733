#pragma once

#include "wasm/app/view_context.h"

namespace marey::app {

/// The ruler above the curves: frame numbers, the playback range with its handles, the frame cursor. Drag scrubs, the
/// wheel zooms, a middle drag pans, a double click shows the whole clip.
class TimelineView {
 public:
  static constexpr float kHeight = 28.0f;

  /// Draws over the full width of the current child window and sets the edges of the shared time window.
  void draw(ViewContext& context);

 private:
  enum class Handle { None, Cursor, RangeIn, RangeOut };

  void place(ViewContext& context);
  void handle_input(ViewContext& context);
  void drag_handle(ViewContext& context);
  [[nodiscard]] Handle handle_at(const ViewContext& context, float x, float y) const;
  void draw_ruler(ViewContext& context) const;
  void draw_range(ViewContext& context) const;
  void draw_cursor(ViewContext& context) const;
  void add_items(ViewContext& context) const;

  float top_ = 0.0f;
  float bottom_ = 0.0f;
  Handle dragged_ = Handle::None;
};

}  // namespace marey::app
