#include "wasm/app/shortcut.h"

#include <imgui_internal.h>

#include <array>
#include <utility>

namespace marey::app {
namespace {

using NamedKey = std::pair<std::string_view, ImGuiKey>;

constexpr std::array kNamedKeys = {
    NamedKey{"Space", ImGuiKey_Space},         NamedKey{"Enter", ImGuiKey_Enter},
    NamedKey{"Escape", ImGuiKey_Escape},       NamedKey{"Tab", ImGuiKey_Tab},
    NamedKey{"Delete", ImGuiKey_Delete},       NamedKey{"Backspace", ImGuiKey_Backspace},
    NamedKey{"Left", ImGuiKey_LeftArrow},      NamedKey{"Right", ImGuiKey_RightArrow},
    NamedKey{"Up", ImGuiKey_UpArrow},          NamedKey{"Down", ImGuiKey_DownArrow},
    NamedKey{"Home", ImGuiKey_Home},           NamedKey{"End", ImGuiKey_End},
    NamedKey{"PageUp", ImGuiKey_PageUp},       NamedKey{"PageDown", ImGuiKey_PageDown},
    NamedKey{"Comma", ImGuiKey_Comma},         NamedKey{"Period", ImGuiKey_Period},
    NamedKey{"Slash", ImGuiKey_Slash},         NamedKey{"Minus", ImGuiKey_Minus},
    NamedKey{"Plus", ImGuiKey_Equal},          NamedKey{"[", ImGuiKey_LeftBracket},
    NamedKey{"]", ImGuiKey_RightBracket},      NamedKey{"KeypadPlus", ImGuiKey_KeypadAdd},
    NamedKey{"KeypadMinus", ImGuiKey_KeypadSubtract},
};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::optional<ImGuiKeyChord> parse_modifier(std::string_view name) {
  if (name == "Ctrl") return ImGuiMod_Ctrl;
  if (name == "Shift") return ImGuiMod_Shift;
  if (name == "Alt") return ImGuiMod_Alt;
  return std::nullopt;
}

std::optional<ImGuiKeyChord> parse_key(std::string_view name) {
  for (const auto& [key_name, key] : kNamedKeys) {
    if (key_name == name) return key;
  }
  if (name == "?") return ImGuiMod_Shift | ImGuiKey_Slash;
  if (name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z') return ImGuiKey_A + (name[0] - 'A');
  if (name.size() == 1 && name[0] >= '0' && name[0] <= '9') return ImGuiKey_0 + (name[0] - '0');
  return std::nullopt;
}

std::string_view first_of_list(std::string_view list) { return trimmed(list.substr(0, list.find(','))); }

std::string_view displayed_key(std::string_view name, bool apple_keys) {
  constexpr std::array kSigns = {std::pair{"Left", "←"}, std::pair{"Right", "→"}, std::pair{"Up", "↑"},
                                 std::pair{"Down", "↓"}, std::pair{"Comma", ","}, std::pair{"Period", "."},
                                 std::pair{"Slash", "/"}, std::pair{"Minus", "-"}, std::pair{"Plus", "+"}};
  constexpr std::array kAppleSigns = {std::pair{"Ctrl", "⌘"}, std::pair{"Shift", "⇧"}, std::pair{"Alt", "⌥"}};
  for (const auto& [key, sign] : kSigns) {
    if (name == key) return sign;
  }
  if (apple_keys) {
    for (const auto& [key, sign] : kAppleSigns) {
      if (name == key) return sign;
    }
  }
  return name;
}

bool repeats(ImGuiKey key) { return key >= ImGuiKey_LeftArrow && key <= ImGuiKey_DownArrow; }

constexpr ImGuiID kShellKeys = 0x4d617265;

constexpr std::array kNavigationKeys = {ImGuiKey_LeftArrow, ImGuiKey_RightArrow, ImGuiKey_UpArrow, ImGuiKey_DownArrow,
                                        ImGuiKey_Home,      ImGuiKey_End,        ImGuiKey_PageUp,  ImGuiKey_PageDown};

bool is_free(ImGuiKey key) {
  const ImGuiID owner = ImGui::GetKeyOwner(key);
  return owner == ImGuiKeyOwner_NoOwner || owner == kShellKeys;
}

}  // namespace

std::optional<ImGuiKeyChord> parse_chord(std::string_view text) {
  text = trimmed(text);
  ImGuiKeyChord chord = 0;
  for (std::size_t plus = text.find('+'); plus != std::string_view::npos; plus = text.find('+')) {
    const auto modifier = parse_modifier(text.substr(0, plus));
    if (!modifier) return std::nullopt;
    chord |= *modifier;
    text.remove_prefix(plus + 1);
  }
  const auto key = parse_key(text);
  if (!key) return std::nullopt;
  return chord | *key;
}

std::vector<ImGuiKeyChord> parse_shortcuts(std::string_view text) {
  std::vector<ImGuiKeyChord> chords;
  while (!text.empty()) {
    if (const auto chord = parse_chord(first_of_list(text))) chords.push_back(*chord);
    const std::size_t comma = text.find(',');
    text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
  }
  return chords;
}

std::string displayed_shortcut(std::string_view text, bool apple_keys) {
  std::string_view rest = first_of_list(text);
  std::string shown;
  while (!rest.empty()) {
    const std::size_t plus = rest.find('+');
    if (!shown.empty()) shown += ' ';
    shown += displayed_key(rest.substr(0, plus), apple_keys);
    rest.remove_prefix(plus == std::string_view::npos ? rest.size() : plus + 1);
  }
  return shown;
}

bool is_chord_pressed(ImGuiKeyChord chord) {
  const auto key = static_cast<ImGuiKey>(chord & ~ImGuiMod_Mask_);
  if (ImGui::GetIO().KeyMods != (chord & ImGuiMod_Mask_)) return false;
  return is_free(key) && ImGui::IsKeyPressed(key, repeats(key));
}

void keep_navigation_keys_for_shortcuts() {
  for (const ImGuiKey key : kNavigationKeys) {
    if (is_free(key)) ImGui::SetKeyOwner(key, kShellKeys);
  }
}

}  // namespace marey::app
