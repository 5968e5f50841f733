#pragma once

#include <imgui.h>

namespace marey::app {

enum class ThemeKind { Dark, Light };

/// Colours by role; the only place where a colour of the page is decided. Values: the token table of
/// `../shared/look.md` and what follows from it. Text tokens have contrast AA on app, panel and raised in both themes.
struct Theme {
  ThemeKind kind = ThemeKind::Dark;
  ImU32 app = 0;        ///< behind the panels
  ImU32 panel = 0;      ///< panel ground
  ImU32 raised = 0;     ///< controls, menus, tool tips
  ImU32 hovered = 0;    ///< raised, under the pointer
  ImU32 pressed = 0;    ///< raised, held down
  ImU32 line = 0;       ///< hairlines
  ImU32 text = 0;
  ImU32 dim_text = 0;
  ImU32 accent = 0;     ///< primary action, focus
  ImU32 on_accent = 0;  ///< text on accent
  ImU32 selection = 0;  ///< selected joint, samples
  ImU32 cursor = 0;     ///< the frame cursor
  ImU32 ok = 0;
  ImU32 warning = 0;
  ImU32 error = 0;
  ImU32 axis[3] = {};   ///< X, Y, Z
  ImU32 left = 0;       ///< left side of the body
  ImU32 right = 0;
  ImU32 middle = 0;
  ImU32 viewport_top = 0;     ///< ground of the viewport, upper edge
  ImU32 viewport_bottom = 0;  ///< and lower edge
  ImU32 grid = 0;
  ImU32 ghost = 0;            ///< the original curve, strobe poses
};

[[nodiscard]] Theme make_theme(ThemeKind kind);

/// The theme for a projector: dim text and lines stand out more.
[[nodiscard]] Theme with_more_contrast(Theme theme);

/// Sets ImGui's style (colours, paddings, rounding) from the theme: 4 px grid, controls 28 px high (40 with touch).
void apply_theme(const Theme& theme, bool touch);

/// `color` with its alpha multiplied by `alpha` in 0..1.
[[nodiscard]] ImU32 with_alpha(ImU32 color, float alpha);

}  // namespace marey::app
