#pragma once

#include <imgui.h>

#include <string_view>

namespace marey::app {

enum class PointerKind { Mouse, Pen, Touch };

/// Modifier keys as JavaScript passes them, a bit each.
enum Modifiers : int { kModifierCtrl = 1, kModifierShift = 2, kModifierAlt = 4, kModifierMeta = 8 };

/// Hands the browser's input events to the current ImGui context. Positions and distances are CSS pixels.
class Input {
 public:
  /// Factor from ImGui units to CSS pixels.
  void set_css_per_unit(float css_per_unit) { css_per_unit_ = css_per_unit; }

  void move_pointer(PointerKind kind, float css_x, float css_y, int modifiers);
  /// The pointer left the page, or the finger was lifted: nothing is hovered any more.
  void leave_pointer();
  /// `button`: 0 left, 1 right, 2 middle (ImGuiMouseButton).
  void press_button(PointerKind kind, int button, bool down, int modifiers);
  /// Distances in lines, up and left positive. `zoom`: a pinch on a track pad, told apart from scrolling by Ctrl.
  void turn_wheel(float lines_x, float lines_y, int modifiers, bool zoom);
  /// `code` and `key` as in KeyboardEvent.
  void press_key(std::string_view code, std::string_view key, bool down, int modifiers);
  void type_text(const char* utf8);
  /// A page without focus holds no key and no button.
  void set_focus(bool focused);

  /// Events that ImGui has put off to a later frame, so that a quick press and release are both seen.
  [[nodiscard]] static bool has_waiting_events();

 private:
  float css_per_unit_ = 1.0f;
};

}  // namespace marey::app
