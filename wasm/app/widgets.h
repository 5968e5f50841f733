#pragma once

#include <span>
#include <string>
#include <string_view>

#include "wasm/app/small_text.h"
#include "wasm/app/view_context.h"

/// The controls of the page: one look, a tool tip on each, each recorded in UiItems. Views use these instead of bare
/// ImGui controls. Ids end with a NUL.
namespace marey::app::ui {

enum class ButtonLook { Plain, Raised, Primary };

/// Button of a command: icon and, with `with_label`, its label; tool tip with help, shortcut and, when disabled, the
/// reason. The item id is the command's id with `id_suffix` behind it. Returns true when it ran.
bool command_button(ViewContext& context, std::string_view command_id, ButtonLook look = ButtonLook::Plain,
                    bool with_label = false, std::string_view id_suffix = {});

/// Icon button that is no command. `tool_tip`: name and what it does.
bool icon_button(ViewContext& context, const char* id, const char* icon, std::string_view tool_tip,
                 bool active = false);

bool text_button(ViewContext& context, const char* id, std::string_view label, std::string_view tool_tip,
                 ButtonLook look = ButtonLook::Raised);

/// How a number is shown and changed.
struct NumberFormat {
  std::string_view unit;  ///< "°", "frames", "s", "units"; shown behind the number
  int decimals = 3;
  double step = 0.1;      ///< per pixel of drag and per arrow key
  double low = -1e12;
  double high = 1e12;
  float width = 96.0f;
};

/// What happened to a number field in this frame. A drag is Live in each frame with one GestureId from begin to end,
/// then Committed or, on Escape, Cancelled. Typing and arrow keys are Committed; steps by arrow key share their
/// GestureId while the field has the focus. Use it for Session::apply_gesture and cancel_gesture.
enum class NumberEvent { None, Live, Committed, Cancelled };

struct NumberResult {
  NumberEvent event = NumberEvent::None;
  double value = 0.0;
  GestureId gesture = 0;
};

/// Number with its unit: drag to change, double click or Enter to type, arrow keys step, Escape reverts.
NumberResult number_field(ViewContext& context, const char* id, std::string_view label, double value,
                          const NumberFormat& format);

/// Search field with a clear button; returns true when the text changed.
bool search_field(ViewContext& context, const char* id, std::string_view hint, std::string& text);

/// A line of text; returns true when it changed.
bool text_field(ViewContext& context, const char* id, std::string_view label, std::string_view tip, std::string& text,
                float width);

/// One entry of a choice; the id is that of its row in the open list.
struct ChoiceOption {
  std::string id;
  std::string label;
};

/// One of several: shows the chosen option, opens the list on a click. `chosen` out of range shows nothing. Returns
/// true when another one was chosen.
bool choice(ViewContext& context, const char* id, std::string_view label, std::string_view tip,
            std::span<const ChoiceOption> options, int& chosen, float width);

bool toggle(ViewContext& context, const char* id, std::string_view label, std::string_view tool_tip, bool& on);

/// Panel title in the title face, 15 semibold, on one 32 px row.
void panel_title(ViewContext& context, std::string_view title);

/// Dim text for labels and units.
void dim_text(const ViewContext& context, std::string_view text);

/// Tool tip of the last item, shown after the usual delay: bold name, sentence, shortcut.
void tool_tip(ViewContext& context, std::string_view name, std::string_view help, std::string_view shortcut = {});

/// The same for an item that stands for a command, with the reason why it cannot run.
void command_tool_tip(ViewContext& context, const Command& command);

/// Text cut to `width` with an ellipsis in the middle; full text as tool tip when it was cut.
void elided_text(ViewContext& context, std::string_view text, float width, ImU32 color);

/// One device pixel in ImGui units.
[[nodiscard]] float device_pixel();

/// Line of one device pixel along the grid of device pixels; `from` and `to` differ in x or in y.
void hairline(ImDrawList& draw_list, ImVec2 from, ImVec2 to, ImU32 color);

/// Soft shadow around the current window. Call right after Begin of a popup, menu or tool tip.
void popup_shadow(const ViewContext& context);

/// A text that may not be UTF-8, as a file name: invalid bytes shown as U+FFFD. Names of joints and findings are UTF-8.
[[nodiscard]] std::string displayable(std::string_view bytes);

}  // namespace marey::app::ui
