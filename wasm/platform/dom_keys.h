#pragma once

#include <imgui.h>

#include <string_view>

namespace marey::app {

/// The key that a browser's keyboard event names, ImGuiKey_None for one that ImGui does not know.
/// `code` is KeyboardEvent.code, the place on the keyboard ("KeyQ", "ArrowLeft"); `key` is KeyboardEvent.key, what the
/// user's layout makes of it. Latin letters and digits follow the layout, as the letters of shortcuts do; all other
/// keys, and letters of other scripts, follow the place.
[[nodiscard]] ImGuiKey find_key(std::string_view code, std::string_view key);

}  // namespace marey::app
