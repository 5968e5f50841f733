#include "tests/app/support/widget_stage.h"

#include <utility>

namespace marey::app {

WidgetStage::WidgetStage(Draw draw) : theme_(make_theme(ThemeKind::Dark)), draw_(std::move(draw)) {
  ImGuiIO& io = ImGui::GetIO();
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  fonts_ = add_fonts(ImGuiStage::font_files());
  frame(3);
}

void WidgetStage::frame(int count) {
  for (int i = 0; i < count; ++i) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(800.0f, 600.0f);
    io.DisplayFramebufferScale = ImVec2(1.0f, 1.0f);
    io.DeltaTime = 1.0f / 60.0f;
    apply_theme(theme_, false);
    ImGui::NewFrame();
    items_.begin_frame();
    ViewContext context{.session = session_, .clip_serial = 0, .commands = commands_, .analysis = analysis_, .options = options_,
                        .time_window = time_window_, .theme = theme_, .fonts = fonts_, .items = items_, .hover = hover_,
                        .next_hover = next_hover_, .status = status_, .refusal = refusal_, .now_s = 0.0, .redraw = redraw_,
                        .widgets = widgets_, .system = system_};
    ImGui::SetNextWindowPos(ImVec2(0.0f, 0.0f));
    ImGui::SetNextWindowSize(io.DisplaySize);
    ImGui::Begin("stage", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    draw_(context);
    ImGui::End();
    ImGui::Render();
    ImGuiStage::accept_textures();
  }
}

void WidgetStage::move_to(const std::string& item_id) {
  mouse_ = center_of(items_, item_id);
  ImGuiStage::move_mouse(mouse_);
  frame(2);
}

void WidgetStage::move_by(ImVec2 by) {
  mouse_ = ImVec2(mouse_.x + by.x, mouse_.y + by.y);
  ImGuiStage::move_mouse(mouse_);
  frame();
}

void WidgetStage::button(bool down) {
  ImGuiStage::press_mouse(down);
  frame();
}

void WidgetStage::click(const std::string& item_id) {
  move_to(item_id);
  button(true);
  button(false);
  frame(2);
}

void WidgetStage::double_click(const std::string& item_id) {
  move_to(item_id);
  for (const bool down : {true, false, true, false}) button(down);
  frame(4);
}

void WidgetStage::press(ImGuiKeyChord chord) {
  ImGuiStage::key_event(chord, true);
  frame();
  ImGuiStage::key_event(chord, false);
  frame(3);
}

void WidgetStage::type(const std::string& text) {
  ImGuiStage::type(text);
  frame(3);
}

}  // namespace marey::app
