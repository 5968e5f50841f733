#pragma once

#include <imgui.h>

#include <string>

#include "wasm/app/fonts.h"
#include "wasm/app/ui_items.h"

namespace marey::app {

/// An ImGui context without a window or GPU, fed with events as the page feeds it.
class ImGuiStage {
 public:
  ImGuiStage();
  ~ImGuiStage();
  ImGuiStage(const ImGuiStage&) = delete;
  ImGuiStage& operator=(const ImGuiStage&) = delete;

  /// Answers ImGui's requests for textures, as a renderer does after each frame.
  static void accept_textures();

  /// The page's typefaces when npm has installed them; ImGui's own otherwise.
  static FontFiles font_files();

  static void move_mouse(ImVec2 position) { ImGui::GetIO().AddMousePosEvent(position.x, position.y); }
  static void press_mouse(bool down) { ImGui::GetIO().AddMouseButtonEvent(ImGuiMouseButton_Left, down); }
  static void key_event(ImGuiKeyChord chord, bool down);
  static void type(const std::string& text) { ImGui::GetIO().AddInputCharactersUTF8(text.c_str()); }

 private:
  ImGuiContext* context_;
};

/// Middle of an item; the test fails when it is not shown.
[[nodiscard]] ImVec2 center_of(const UiItems& items, const std::string& id);
[[nodiscard]] bool is_shown(const UiItems& items, const std::string& id);

}  // namespace marey::app
