#include "wasm/views/problems_view.h"

#include <fmt/format.h>

#include <string>

#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

constexpr float kPadding = 12.0f;
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

std::string place_text(const Diagnostic& diagnostic) {
  std::string text = diagnostic.place.line > 0
                         ? fmt::format("line {}, column {}", diagnostic.place.line, diagnostic.place.column)
                         : std::string("whole file");
  if (diagnostic.count > 1) text += fmt::format(", {} times", diagnostic.count);
  return text;
}

void draw_nothing_found(const ViewContext& context, bool has_clip) {
  ImGui::SetCursorPos(ImVec2(kPadding, 16.0f));
  ImGui::PushStyleColor(ImGuiCol_Text, has_clip ? context.theme.ok : context.theme.dim_text);
  ImGui::TextUnformatted(has_clip ? icons::kCircleCheck : icons::kFile);
  ImGui::PopStyleColor();
  ImGui::SameLine(0.0f, 8.0f);
  ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - kPadding);
  ui::dim_text(context, has_clip ? "Nothing to report: the file reads as it is written." : "No file is open.");
  ImGui::PopTextWrapPos();
}

}  // namespace

void ProblemsView::draw_entry(ViewContext& context, const Diagnostic& diagnostic, int index) {
  const SeverityLook look = look_of(context.theme, diagnostic.severity);
  ImGui::SetCursorPosX(kPadding);
  const ImVec2 top = ImGui::GetCursorScreenPos();
  ImGui::BeginGroup();
  ImGui::PushStyleColor(ImGuiCol_Text, look.color);
  ImGui::TextUnformatted(look.icon);
  ImGui::PopStyleColor();
  ImGui::SameLine(0.0f, kTextIndent - Fonts::kTextSize);
  ImGui::BeginGroup();
  ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - kPadding);
  const std::string message = ui::displayable(diagnostic.message);
  ImGui::TextUnformatted(message.c_str(), message.c_str() + message.size());
  ui::dim_text(context, place_text(diagnostic));
  ImGui::PopTextWrapPos();
  ImGui::EndGroup();
  ImGui::EndGroup();
  context.items.add_last(fmt::format("problems.entry.{}", index), message);
  ImGui::Dummy(ImVec2(0.0f, 6.0f));
  const float bottom = ImGui::GetCursorScreenPos().y;
  ui::hairline(*ImGui::GetWindowDrawList(), ImVec2(top.x, bottom),
               ImVec2(top.x + ImGui::GetWindowWidth() - 2.0f * kPadding, bottom), context.theme.line);
  ImGui::Dummy(ImVec2(0.0f, 7.0f));
}

void ProblemsView::draw(ViewContext& context) {
  const Document& document = context.session.document;
  const auto& list = document.diagnostics().list();
  if (list.empty()) {
    draw_nothing_found(context, document.skeleton().joint_count() > 0);
    return;
  }
  ImGui::Dummy(ImVec2(0.0f, 12.0f));
  for (int i = 0; i < size_of(list); ++i) draw_entry(context, list[idx(i)], i);
}

}  // namespace marey::app
