#include "wasm/platform/dom_keys.h"

#include <algorithm>
#include <array>

namespace marey::app {
namespace {

struct NamedKey {
  std::string_view code;
  ImGuiKey key;
};

constexpr std::array kNamedKeys = {
    NamedKey{"AltLeft", ImGuiKey_LeftAlt},
    NamedKey{"AltRight", ImGuiKey_RightAlt},
    NamedKey{"ArrowDown", ImGuiKey_DownArrow},
    NamedKey{"ArrowLeft", ImGuiKey_LeftArrow},
    NamedKey{"ArrowRight", ImGuiKey_RightArrow},
    NamedKey{"ArrowUp", ImGuiKey_UpArrow},
    NamedKey{"Backquote", ImGuiKey_GraveAccent},
    NamedKey{"Backslash", ImGuiKey_Backslash},
    NamedKey{"Backspace", ImGuiKey_Backspace},
    NamedKey{"BracketLeft", ImGuiKey_LeftBracket},
    NamedKey{"BracketRight", ImGuiKey_RightBracket},
    NamedKey{"CapsLock", ImGuiKey_CapsLock},
    NamedKey{"Comma", ImGuiKey_Comma},
    NamedKey{"ContextMenu", ImGuiKey_Menu},
    NamedKey{"ControlLeft", ImGuiKey_LeftCtrl},
    NamedKey{"ControlRight", ImGuiKey_RightCtrl},
    NamedKey{"Delete", ImGuiKey_Delete},
    NamedKey{"End", ImGuiKey_End},
    NamedKey{"Enter", ImGuiKey_Enter},
    NamedKey{"Equal", ImGuiKey_Equal},
    NamedKey{"Escape", ImGuiKey_Escape},
    NamedKey{"F1", ImGuiKey_F1},
    NamedKey{"F10", ImGuiKey_F10},
    NamedKey{"F11", ImGuiKey_F11},
    NamedKey{"F12", ImGuiKey_F12},
    NamedKey{"F2", ImGuiKey_F2},
    NamedKey{"F3", ImGuiKey_F3},
    NamedKey{"F4", ImGuiKey_F4},
    NamedKey{"F5", ImGuiKey_F5},
    NamedKey{"F6", ImGuiKey_F6},
    NamedKey{"F7", ImGuiKey_F7},
    NamedKey{"F8", ImGuiKey_F8},
    NamedKey{"F9", ImGuiKey_F9},
    NamedKey{"Home", ImGuiKey_Home},
    NamedKey{"Insert", ImGuiKey_Insert},
    NamedKey{"IntlBackslash", ImGuiKey_Oem102},
    NamedKey{"MetaLeft", ImGuiKey_LeftSuper},
    NamedKey{"MetaRight", ImGuiKey_RightSuper},
    NamedKey{"Minus", ImGuiKey_Minus},
    NamedKey{"NumLock", ImGuiKey_NumLock},
    NamedKey{"NumpadAdd", ImGuiKey_KeypadAdd},
    NamedKey{"NumpadDecimal", ImGuiKey_KeypadDecimal},
    NamedKey{"NumpadDivide", ImGuiKey_KeypadDivide},
    NamedKey{"NumpadEnter", ImGuiKey_KeypadEnter},
    NamedKey{"NumpadEqual", ImGuiKey_KeypadEqual},
    NamedKey{"NumpadMultiply", ImGuiKey_KeypadMultiply},
    NamedKey{"NumpadSubtract", ImGuiKey_KeypadSubtract},
    NamedKey{"PageDown", ImGuiKey_PageDown},
    NamedKey{"PageUp", ImGuiKey_PageUp},
    NamedKey{"Pause", ImGuiKey_Pause},
    NamedKey{"Period", ImGuiKey_Period},
    NamedKey{"PrintScreen", ImGuiKey_PrintScreen},
    NamedKey{"Quote", ImGuiKey_Apostrophe},
    NamedKey{"ScrollLock", ImGuiKey_ScrollLock},
    NamedKey{"Semicolon", ImGuiKey_Semicolon},
    NamedKey{"ShiftLeft", ImGuiKey_LeftShift},
    NamedKey{"ShiftRight", ImGuiKey_RightShift},
    NamedKey{"Slash", ImGuiKey_Slash},
    NamedKey{"Space", ImGuiKey_Space},
    NamedKey{"Tab", ImGuiKey_Tab},
};
static_assert(std::is_sorted(kNamedKeys.begin(), kNamedKeys.end(),
                             [](const NamedKey& a, const NamedKey& b) { return a.code < b.code; }));

ImGuiKey key_behind(ImGuiKey first, char character, char first_character) {
  return static_cast<ImGuiKey>(first + (character - first_character));
}

ImGuiKey find_letter_or_digit(char character) {
  if (character >= 'a' && character <= 'z') return key_behind(ImGuiKey_A, character, 'a');
  if (character >= 'A' && character <= 'Z') return key_behind(ImGuiKey_A, character, 'A');
  if (character >= '0' && character <= '9') return key_behind(ImGuiKey_0, character, '0');
  return ImGuiKey_None;
}

bool is_numbered(std::string_view code, std::string_view prefix) {
  return code.size() == prefix.size() + 1 && code.substr(0, prefix.size()) == prefix;
}

}  // namespace

ImGuiKey find_key(std::string_view code, std::string_view key) {
  if (is_numbered(code, "Numpad") && code.back() >= '0' && code.back() <= '9') {
    return key_behind(ImGuiKey_Keypad0, code.back(), '0');
  }
  if (key.size() == 1 && code.substr(0, 6) != "Numpad") {
    if (const ImGuiKey found = find_letter_or_digit(key.front()); found != ImGuiKey_None) return found;
  }
  if (is_numbered(code, "Key") || is_numbered(code, "Digit")) return find_letter_or_digit(code.back());
  const auto* const found = std::lower_bound(kNamedKeys.begin(), kNamedKeys.end(), code,
                                             [](const NamedKey& named, std::string_view wanted) { return named.code < wanted; });
  return found != kNamedKeys.end() && found->code == code ? found->key : ImGuiKey_None;
}

}  // namespace marey::app
