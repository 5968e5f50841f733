#pragma once

#include <functional>

#include "core/editing/edit.h"
#include "wasm/app/view_context.h"
#include "wasm/app/widgets.h"

namespace marey::app {

/// Turns what happened to a number field into an edit of the clip: one drag is one step of undo, Escape takes it back.
/// A refused edit is said in the status line.
void apply_number(ViewContext& context, const ui::NumberResult& result,
                  const std::function<Edit(const Clip&)>& make_edit);

}  // namespace marey::app
