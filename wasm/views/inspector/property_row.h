#pragma once

#include <string>
#include <string_view>

#include "wasm/app/view_context.h"

/// Rows of the inspector: a dim label on the left, the value on the right.
namespace marey::app::inspector {

inline constexpr float kPadding = 12.0f;
inline constexpr float kLabelWidth = 96.0f;
inline constexpr float kRowHeight = 28.0f;

/// Small heading above a group of rows.
void heading(ViewContext& context, std::string_view text);

/// Begins a row and leaves the cursor at its value. Returns the width that is left for the value.
float begin_row(ViewContext& context, std::string_view label);
void end_row();

/// A row whose value is text that cannot be edited; `number` sets it in the monospaced face.
void text_row(ViewContext& context, std::string_view label, std::string_view value, bool number = false);

/// The same, recorded in UiItems with its value.
void known_text_row(ViewContext& context, std::string_view id, std::string_view label, std::string_view value,
                    bool number = false);

}  // namespace marey::app::inspector
