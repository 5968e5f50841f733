#include "wasm/views/inspector/property_row.h"

#include <algorithm>

#include "wasm/app/widgets.h"

namespace marey::app::inspector {

void heading(ViewContext& context, std::string_view text) {
  ImGui::Dummy({0.0f, 8.0f});
  ImGui::SetCursorPosX(kPadding);
  ImGui::PushFont(context.fonts.semibold, Fonts::kTextSize);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopFont();
  ImGui::Dummy({0.0f, 2.0f});
}

float begin_row(ViewContext& context, std::string_view label) {
  ImGui::SetCursorPosX(kPadding);
  const float top = ImGui::GetCursorPosY();
  ImGui::SetCursorPosY(top + 0.5f * (kRowHeight - ImGui::GetTextLineHeight()));
  ui::dim_text(context, label);
  ImGui::SetCursorPos({kPadding + kLabelWidth, top});
  return std::max(40.0f, ImGui::GetContentRegionAvail().x - kPadding);
}

void end_row() { ImGui::Dummy({0.0f, 0.0f}); }

void text_row(ViewContext& context, std::string_view label, const std::string& value, bool number) {
  const float width = begin_row(context, label);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 0.5f * (kRowHeight - ImGui::GetTextLineHeight()));
  ImGui::PushFont(number ? context.fonts.mono : context.fonts.text, Fonts::kTextSize);
  ui::elided_text(context, value, width, context.theme.text);
  ImGui::PopFont();
  ImGui::Dummy({0.0f, 4.0f});
}

}  // namespace marey::app::inspector
