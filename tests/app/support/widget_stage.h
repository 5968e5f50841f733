#pragma once

#include <functional>
#include <string>

#include "tests/app/support/imgui_stage.h"
#include "wasm/app/view_context.h"

namespace marey::app {

/// One window with controls of the widget library in it, used by mouse and keys.
class WidgetStage {
 public:
  using Draw = std::function<void(ViewContext&)>;

  /// `draw` is called in each frame.
  explicit WidgetStage(Draw draw);

  void frame(int count = 1);
  void move_to(const std::string& item_id);
  void move_by(ImVec2 by);
  void button(bool down);
  void click(const std::string& item_id);
  void double_click(const std::string& item_id);
  void press(ImGuiKeyChord chord);
  void type(const std::string& text);

  [[nodiscard]] const UiItems& items() const { return items_; }
  [[nodiscard]] const std::string& status() const { return status_; }
  CommandRegistry& commands() { return commands_; }

 private:
  ImGuiStage imgui_;
  Session session_;
  CommandRegistry commands_;
  Analysis analysis_;
  ViewOptions options_;
  TimeWindow time_window_;
  Theme theme_;
  Fonts fonts_;
  UiItems items_;
  Hover hover_;
  Hover next_hover_;
  std::string status_;
  std::string refusal_;
  WidgetState widgets_;
  SystemPreferences system_;
  bool redraw_ = false;
  ImVec2 mouse_;
  Draw draw_;
};

}  // namespace marey::app
