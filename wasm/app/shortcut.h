#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace marey::app {

/// The chord that a text like "Ctrl+Shift+Z", "Space" or "?" names; nothing if it names none. Ctrl stands for Cmd on
/// Apple keyboards, where ImGui exchanges the two.
[[nodiscard]] std::optional<ImGuiKeyChord> parse_chord(std::string_view text);

/// All chords of a comma-separated list; what cannot be parsed is left out.
[[nodiscard]] std::vector<ImGuiKeyChord> parse_shortcuts(std::string_view text);

/// The first chord of a list as people read it: "Ctrl Z", on Apple keyboards "⌘ Z"; "" for an empty list.
[[nodiscard]] std::string displayed_shortcut(std::string_view text, bool apple_keys);

/// The chord was pressed in this frame and no control has claimed its key. Holding a key down repeats only for arrows,
/// so that play does not flicker.
[[nodiscard]] bool is_chord_pressed(ImGuiKeyChord chord);

/// Keeps arrows, Home, End and the page keys from moving ImGui's focus in the next frame, so that they step through
/// frames. Call at the end of each frame in which no focus ring is shown and no menu is open.
void keep_navigation_keys_for_shortcuts();

}  // namespace marey::app
