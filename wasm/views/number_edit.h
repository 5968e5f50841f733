#pragma once

#include <functional>

#include "core/editing/edit.h"
#include "wasm/app/view_context.h"
#include "wasm/app/widgets.h"

namespace marey::app {

/// Turns what happened to a number field into an edit of the clip: one drag is one step of undo, Escape takes it back.
/// A refused edit is said in the status line.
void apply_number_event(ViewContext& context, const ui::NumberResult& result, const History::MakeEdit& make_edit);

/// The same, at no cost in the many frames in which nothing happens.
template <class MakeEdit>
void apply_number(ViewContext& context, const ui::NumberResult& result, const MakeEdit& make_edit) {
  if (result.event != ui::NumberEvent::None) apply_number_event(context, result, make_edit);
}

}  // namespace marey::app
