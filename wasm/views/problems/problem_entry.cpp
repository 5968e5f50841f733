#include "wasm/views/problems/problem_entry.h"

#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"
#include "wasm/views/inspector/property_row.h"

namespace marey::app {
namespace {

constexpr float kTextIndent = 24.0f;

struct SeverityLook {
  const char* icon;
  ImU32 color;
};

SeverityLook look_of(const Theme& theme, Severity severity) {
  switch (severity) {
    case Severity::Error: return {icons::kCircleAlert, theme.error};
    case Severity::Warning: return {icons::kTriangleAlert, theme.warning};
    case Severity::Note: break;
  }
  return {icons::kInfo, theme.accent};
}

void draw_texts(const ViewContext& context, const ProblemEntry& entry) {
  const SeverityLook look = look_of(context.theme, entry.severity);
  ImGui::BeginGroup();
  ImGui::PushStyleColor(ImGuiCol_Text, look.color);
  ImGui::TextUnformatted(look.icon);
  ImGui::PopStyleColor();
  ImGui::SameLine(0.0f, kTextIndent - Fonts::kTextSize);
  ImGui::BeginGroup();
  ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - inspector::kPadding);
  ImGui::TextUnformatted(entry.message.c_str(), entry.message.c_str() + entry.message.size());
  for (const std::string& line : entry.details) ui::dim_text(context, line);
  ImGui::PopTextWrapPos();
  ImGui::EndGroup();
  ImGui::EndGroup();
}

void show_that_it_can_be_clicked(ViewContext& context, const ProblemEntry& entry) {
  const ImVec2 min = ImGui::GetItemRectMin();
  const ImVec2 max = ImGui::GetItemRectMax();
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  context.status = entry.click_help;
  ImGui::GetWindowDrawList()->AddRectFilled({min.x - 6.0f, min.y - 4.0f}, {max.x + 6.0f, max.y + 4.0f},
                                            with_alpha(context.theme.text, 0.05f), 4.0f);
}

}  // namespace

bool draw_problem_entry(ViewContext& context, const ProblemEntry& entry) {
  ImGui::SetCursorPosX(inspector::kPadding);
  const ImVec2 top = ImGui::GetCursorScreenPos();
  draw_texts(context, entry);
  const ImVec2 end = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(top);
  const ImVec2 size(ImGui::GetContentRegionAvail().x - inspector::kPadding, end.y - top.y);
  const bool pressed = ImGui::InvisibleButton(entry.id.c_str(), size, ImGuiButtonFlags_EnableNav);
  context.items.add_last(entry.id, entry.message);
  if (!entry.click_help.empty() && ImGui::IsItemHovered()) show_that_it_can_be_clicked(context, entry);
  ImGui::Dummy(ImVec2(0.0f, 6.0f));
  return pressed && !entry.click_help.empty();
}

void end_problem_entry(const ViewContext& context) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float left = ImGui::GetWindowPos().x + inspector::kPadding;
  ui::hairline(*ImGui::GetWindowDrawList(), ImVec2(left, at.y),
               ImVec2(left + ImGui::GetWindowWidth() - 2.0f * inspector::kPadding, at.y), context.theme.line);
  ImGui::Dummy(ImVec2(0.0f, 7.0f));
}

}  // namespace marey::app
