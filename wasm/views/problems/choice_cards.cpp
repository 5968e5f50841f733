#include "wasm/views/problems/choice_cards.h"

#include <algorithm>
#include <cmath>

#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"
#include "wasm/views/inspector/property_row.h"

namespace marey::app {
namespace {

constexpr float kGap = 6.0f;
constexpr float kLeastWidth = 112.0f;
constexpr float kPictureHeight = 84.0f;
constexpr float kLineHeight = 18.0f;
constexpr float kInset = 8.0f;

float card_height(const ChoiceCard& card) {
  const float texts = 2.0f * kInset + (card.detail.empty() ? 1.0f : 2.0f) * kLineHeight - 2.0f;
  return texts + (card.draw_picture ? kPictureHeight : 0.0f);
}

void draw_line(const ViewContext& context, ImFont* font, ImU32 color, const std::string& text, ImVec2 at, float right) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(at, ImVec2(right, at.y + kLineHeight), true);
  list.AddText(font, font == context.fonts.semibold ? Fonts::kTextSize : Fonts::kSmallSize, at, color, text.c_str());
  list.PopClipRect();
}

void draw_look(const ViewContext& context, const ChoiceCard& card) {
  const Theme& theme = context.theme;
  const ImVec2 min = ImGui::GetItemRectMin();
  const ImVec2 max = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool lifted = ImGui::IsItemHovered() && card.blocked.empty() && !card.chosen;
  list.AddRectFilled(min, max, lifted ? theme.hovered : theme.raised, 6.0f);
  list.AddRect(min, max, card.chosen ? theme.accent : theme.line, 6.0f, 0, card.chosen ? 1.5f : ui::device_pixel());
  float y = min.y + kInset - 1.0f;
  if (card.draw_picture) {
    card.draw_picture(min, ImVec2(max.x, min.y + kPictureHeight));
    y += kPictureHeight;
  }
  const float mark = card.chosen ? Fonts::kTextSize + 6.0f : 0.0f;
  if (card.chosen) list.AddText(ImVec2(min.x + kInset, y), theme.accent, icons::kCheck);
  const ImU32 color = card.blocked.empty() ? theme.text : theme.dim_text;
  draw_line(context, context.fonts.semibold, color, card.label, ImVec2(min.x + kInset + mark, y), max.x - 4.0f);
  draw_line(context, context.fonts.text, theme.dim_text, card.detail, ImVec2(min.x + kInset, y + kLineHeight), max.x - 4.0f);
}

bool draw_card(ViewContext& context, const ChoiceCard& card, ImVec2 size) {
  const bool pressed = ImGui::InvisibleButton(card.id.c_str(), size, ImGuiButtonFlags_EnableNav);
  draw_look(context, card);
  context.items.add_last(card.id, card.label);
  ui::tool_tip(context, card.label, card.blocked.empty() ? card.help : card.blocked);
  return pressed && card.blocked.empty() && !card.chosen;
}

}  // namespace

int draw_choice_cards(ViewContext& context, const std::vector<ChoiceCard>& cards) {
  const float room = ImGui::GetWindowWidth() - 2.0f * inspector::kPadding;
  const int fitting = std::max(1, static_cast<int>((room + kGap) / (kLeastWidth + kGap)));
  const int columns = std::min(size_of(cards), fitting);
  if (columns == 0) return -1;
  const float width = std::floor((room - kGap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
  float height = 0.0f;
  for (const ChoiceCard& card : cards) height = std::max(height, card_height(card));
  int pressed = -1;
  for (int i = 0; i < size_of(cards); ++i) {
    if (i % columns == 0) {
      ImGui::SetCursorPosX(inspector::kPadding);
    } else {
      ImGui::SameLine(0.0f, kGap);
    }
    if (draw_card(context, cards[idx(i)], ImVec2(width, height))) pressed = i;
    if (i % columns == columns - 1 || i + 1 == size_of(cards)) ImGui::Dummy(ImVec2(0.0f, kGap));
  }
  return pressed;
}

}  // namespace marey::app
