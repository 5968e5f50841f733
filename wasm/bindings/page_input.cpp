#include <emscripten/emscripten.h>

#include "wasm/bindings/page_binding.h"

using marey::app::PointerKind;

/// `kind`: 0 mouse, 1 pen, 2 touch. `modifiers`: bits as in marey::app::Modifiers. Lengths are CSS pixels.
extern "C" {

EMSCRIPTEN_KEEPALIVE void marey_pointer_move(PageBinding* binding, int kind, float x, float y, int modifiers) {
  binding->page.input().move_pointer(static_cast<PointerKind>(kind), x, y, modifiers);
}

EMSCRIPTEN_KEEPALIVE void marey_pointer_leave(PageBinding* binding) { binding->page.input().leave_pointer(); }

/// `button`: 0 left, 1 right, 2 middle.
EMSCRIPTEN_KEEPALIVE void marey_pointer_button(PageBinding* binding, int kind, int button, int down, int modifiers) {
  binding->page.input().press_button(static_cast<PointerKind>(kind), button, down != 0, modifiers);
}

EMSCRIPTEN_KEEPALIVE void marey_wheel(PageBinding* binding, float lines_x, float lines_y, int modifiers, int zoom) {
  binding->page.input().turn_wheel(lines_x, lines_y, modifiers, zoom != 0);
}

EMSCRIPTEN_KEEPALIVE void marey_key(PageBinding* binding, const char* code, size_t code_size, const char* key,
                                    size_t key_size, int down, int modifiers) {
  binding->page.input().press_key(view_of(code, code_size), view_of(key, key_size), down != 0, modifiers);
}

EMSCRIPTEN_KEEPALIVE void marey_text(PageBinding* binding, const char* text, size_t text_size) {
  binding->page.input().type_text(std::string(view_of(text, text_size)).c_str());
}

EMSCRIPTEN_KEEPALIVE void marey_focus(PageBinding* binding, int focused) {
  binding->page.input().set_focus(focused != 0);
}

/// 1 while input waits for a further frame.
EMSCRIPTEN_KEEPALIVE int marey_has_waiting_input(PageBinding* /*binding*/) {
  return marey::app::Input::has_waiting_events() ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE void marey_set_clipboard_text(PageBinding* binding, const char* text, size_t text_size) {
  binding->page.set_clipboard_text(std::string(view_of(text, text_size)));
}

}  // extern "C"
