#include "wasm/views/inspector/property_row.h"

#include <algorithm>
#include <cmath>

#include "wasm/app/widgets.h"

namespace marey::app::inspector {
namespace {

constexpr float kRowGap = 4.0f;
constexpr float kNumberInset = 8.0f;

// The label stands in the middle of a row of this height.
float begin_row(ViewContext& context, std::string_view label, float height) {
  ImGui::SetCursorPosX(kPadding);
  const float top = ImGui::GetCursorPosY();
  ImGui::SetCursorPosY(top + std::round(0.5f * (height - ImGui::GetTextLineHeight())));
  if (!label.empty()) ui::elided_text(context, label, kLabelWidth - 6.0f, context.theme.dim_text);
  ImGui::SetCursorPos({kPadding + kLabelWidth, top});
  return std::max(40.0f, ImGui::GetContentRegionAvail().x - kPadding);
}

}  // namespace

void heading(ViewContext& context, std::string_view text) {
  ImGui::Dummy({0.0f, 8.0f});
  ImGui::SetCursorPosX(kPadding);
  ImGui::PushFont(context.fonts.semibold, Fonts::kTextSize);
  ui::elided_text(context, text, ImGui::GetContentRegionAvail().x - kPadding, context.theme.text);
  ImGui::PopFont();
  ImGui::Dummy({0.0f, 2.0f});
}

float begin_row(ViewContext& context, std::string_view label) {
  return begin_row(context, label, ImGui::GetFrameHeight());
}

void end_row() { ImGui::Dummy({0.0f, kRowGap}); }

void text_row(ViewContext& context, std::string_view label, std::string_view value, bool number) {
  float width = begin_row(context, label, kRowHeight);
  const float top = ImGui::GetCursorPosY();
  ImGui::SetCursorPosY(top + 0.5f * (kRowHeight - ImGui::GetTextLineHeight()));
  ImGui::PushFont(number ? context.fonts.mono : context.fonts.text, Fonts::kTextSize);
  if (number) {
    // Under the numbers of the fields, which stand at the right edge; a long one takes the room of its label.
    const float label_end = ImGui::CalcTextSize(label.data(), label.data() + label.size()).x - kLabelWidth + 8.0f;
    const float shift = width - kNumberInset - ImGui::CalcTextSize(value.data(), value.data() + value.size()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(label_end, shift));
    width -= std::max(label_end, shift);
  }
  ui::elided_text(context, value, width, context.theme.text);
  ImGui::PopFont();
  ImGui::SetCursorPosY(top + kRowHeight);
  ImGui::Dummy({0.0f, 0.0f});
}

void known_text_row(ViewContext& context, std::string_view id, std::string_view label, std::string_view value,
                    bool number) {
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  text_row(context, label, value, number);
  context.items.add(id, value, min, {min.x + width, min.y + kRowHeight});
}

}  // namespace marey::app::inspector
