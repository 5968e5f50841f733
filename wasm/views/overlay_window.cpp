#include "wasm/views/overlay_window.h"

#include <algorithm>
#include <cmath>

#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

constexpr float kMargin = 12.0f;
constexpr float kPadding = 20.0f;

bool is_clicked_beside() {
  if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left) || ImGui::IsWindowAppearing()) return false;
  const ImVec2 min = ImGui::GetWindowPos();
  const ImVec2 max(min.x + ImGui::GetWindowWidth(), min.y + ImGui::GetWindowHeight());
  return !ImGui::IsMouseHoveringRect(min, max, false);
}

}  // namespace

void begin_overlay(const ViewContext& context, const OverlayWindow& window, bool& open) {
  const ImVec2 page = ImGui::GetIO().DisplaySize;
  const ImVec2 size(std::min(window.wanted_size.x, page.x - 2.0f * kMargin),
                    std::min(window.wanted_size.y, page.y - 2.0f * kMargin));
  ImGui::SetNextWindowPos(ImVec2(std::round((page.x - size.x) * 0.5f), std::round((page.y - size.y) * window.top_share)));
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 10.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, context.theme.panel);
  ImGui::Begin(window.name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  if (ImGui::IsWindowAppearing()) ImGui::SetWindowFocus();
  ui::popup_shadow(context);
  if (is_clicked_beside()) open = false;
}

void end_overlay() { ImGui::End(); }

void draw_overlay_title(ViewContext& context, const char* title, const char* close_id, bool& open) {
  const float height = ImGui::GetFrameHeight();
  ImGui::SetCursorPos(ImVec2(ImGui::GetWindowWidth() - height - 12.0f, 12.0f));
  if (ui::icon_button(context, close_id, icons::kX, "Close. Escape does the same.")) open = false;
  ImGui::SetCursorPos(ImVec2(kPadding, std::round(12.0f + (height - Fonts::kTitleSize) * 0.5f)));
  ImGui::PushFont(context.fonts.semibold, Fonts::kTitleSize);
  ImGui::TextUnformatted(title);
  ImGui::PopFont();
  ImGui::SetCursorPos(ImVec2(kPadding, 12.0f + height + 8.0f));
}

}  // namespace marey::app
