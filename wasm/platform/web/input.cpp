#include "wasm/platform/web/input.h"

#include <imgui_internal.h>

#include <cfloat>

#include "wasm/platform/dom_keys.h"

namespace marey::app {
namespace {

ImGuiMouseSource mouse_source(PointerKind kind) {
  switch (kind) {
    case PointerKind::Pen: return ImGuiMouseSource_Pen;
    case PointerKind::Touch: return ImGuiMouseSource_TouchScreen;
    case PointerKind::Mouse: break;
  }
  return ImGuiMouseSource_Mouse;
}

void set_modifiers(ImGuiIO& io, int modifiers) {
  io.AddKeyEvent(ImGuiMod_Ctrl, (modifiers & kModifierCtrl) != 0);
  io.AddKeyEvent(ImGuiMod_Shift, (modifiers & kModifierShift) != 0);
  io.AddKeyEvent(ImGuiMod_Alt, (modifiers & kModifierAlt) != 0);
  io.AddKeyEvent(ImGuiMod_Super, (modifiers & kModifierMeta) != 0);
}

}  // namespace

void Input::move_pointer(PointerKind kind, float css_x, float css_y, int modifiers) {
  ImGuiIO& io = ImGui::GetIO();
  set_modifiers(io, modifiers);
  io.AddMouseSourceEvent(mouse_source(kind));
  io.AddMousePosEvent(css_x / css_per_unit_, css_y / css_per_unit_);
}

void Input::leave_pointer() { ImGui::GetIO().AddMousePosEvent(-FLT_MAX, -FLT_MAX); }

void Input::press_button(PointerKind kind, int button, bool down, int modifiers) {
  ImGuiIO& io = ImGui::GetIO();
  set_modifiers(io, modifiers);
  io.AddMouseSourceEvent(mouse_source(kind));
  io.AddMouseButtonEvent(button, down);
}

void Input::turn_wheel(float lines_x, float lines_y, int modifiers, bool zoom) {
  ImGuiIO& io = ImGui::GetIO();
  // ImGui exchanges Ctrl and Super on a Mac.
  const int zoom_modifier = io.ConfigMacOSXBehaviors ? kModifierMeta : kModifierCtrl;
  set_modifiers(io, zoom ? zoom_modifier : modifiers);
  io.AddMouseWheelEvent(lines_x, lines_y);
  if (zoom) set_modifiers(io, 0);
}

void Input::press_key(std::string_view code, std::string_view key, bool down, int modifiers) {
  ImGuiIO& io = ImGui::GetIO();
  set_modifiers(io, modifiers);
  if (const ImGuiKey found = find_key(code, key); found != ImGuiKey_None) io.AddKeyEvent(found, down);
}

void Input::type_text(const char* utf8) { ImGui::GetIO().AddInputCharactersUTF8(utf8); }

void Input::set_focus(bool focused) { ImGui::GetIO().AddFocusEvent(focused); }

bool Input::has_waiting_events() { return !ImGui::GetCurrentContext()->InputEventsQueue.empty(); }

}  // namespace marey::app
