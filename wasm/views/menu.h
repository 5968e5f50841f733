#pragma once

#include <span>
#include <string_view>

#include "wasm/app/view_context.h"

namespace marey::app {

/// What a menu lists: ids of commands, "" for a line between groups, "#Title" for a heading. Commands that do not exist
/// are left out.
using MenuEntries = std::span<const std::string_view>;

/// Draws the rows of an open popup. Closes it when a command ran.
void draw_menu(ViewContext& context, MenuEntries entries);

/// Opens the popup `id` below the last item and draws the menu in it while it is open. Returns true while it is.
bool draw_menu_popup(ViewContext& context, const char* id, ImVec2 position, MenuEntries entries);

}  // namespace marey::app
