#include "wasm/views/welcome_view.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"
#include "wasm/views/overlay_window.h"
#include "wasm/views/sample_pictures.h"

namespace marey::app {
namespace {

constexpr float kPadding = 20.0f;
constexpr float kGap = 12.0f;
constexpr float kCardWidth = 168.0f;
constexpr float kPictureHeight = 116.0f;
constexpr float kCardTextHeight = 64.0f;
constexpr double kCycle_s = 2.4;
constexpr char kPromise[] = "View and edit motion capture right here. Your files never leave this computer.";

ImVec2 wanted_size(bool compact) {
  constexpr auto kCount = static_cast<float>(kSamples.size());
  if (compact) return {420.0f, 480.0f};
  return {kCount * kCardWidth + (kCount - 1.0f) * kGap + 2.0f * kPadding, kPictureHeight + kCardTextHeight + 150.0f};
}

void draw_card_text(const ViewContext& context, const Sample& sample, ImVec2 min, float width) {
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const ImVec2 title(min.x + 10.0f, min.y + 8.0f);
  draw_list.AddText(context.fonts.semibold, Fonts::kTextSize, title, context.theme.text, sample.title.data(),
                    sample.title.data() + sample.title.size());
  draw_list.AddText(context.fonts.text, Fonts::kSmallSize, ImVec2(title.x, title.y + 19.0f), context.theme.dim_text,
                    sample.summary.data(), sample.summary.data() + sample.summary.size(), width - 20.0f);
}

}  // namespace

void WelcomeView::draw_card(ViewContext& context, const Sample& sample, ImVec2 size) {
  const std::string id = "file.sample." + std::string(sample.id);
  const bool pressed = ImGui::InvisibleButton(id.c_str(), size, ImGuiButtonFlags_EnableNav);
  const bool hovered = ImGui::IsItemHovered();
  const ImVec2 min = ImGui::GetItemRectMin();
  const ImVec2 max = ImGui::GetItemRectMax();
  const Theme& theme = context.theme;
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const float picture_bottom = max.y - kCardTextHeight;
  draw_list.AddRectFilled(min, max, hovered ? theme.hovered : theme.raised, 6.0f);
  draw_list.AddRectFilledMultiColor(ImVec2(min.x + 1.0f, min.y + 6.0f), ImVec2(max.x - 1.0f, picture_bottom),
                                    theme.viewport_top, theme.viewport_top, theme.viewport_bottom, theme.viewport_bottom);
  draw_list.AddRectFilled(ImVec2(min.x + 1.0f, min.y + 1.0f), ImVec2(max.x - 1.0f, min.y + 7.0f), theme.viewport_top, 6.0f,
                          ImDrawFlags_RoundCornersTop);
  const double still = 0.16;
  const double phase = context.system.reduced_motion ? still : context.now_s / kCycle_s;
  draw_sample_picture(draw_list, theme, sample.id, ImVec2(min.x + 4.0f, min.y + 4.0f), ImVec2(max.x - 4.0f, picture_bottom - 4.0f),
                      phase);
  draw_list.AddRect(min, max, hovered ? theme.accent : theme.line, 6.0f, 0, hovered ? 1.5f : ui::device_pixel());
  draw_card_text(context, sample, ImVec2(min.x, picture_bottom), size.x);
  if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  context.items.add_last("welcome." + std::string(sample.id), std::string(sample.title));
  if (pressed) context.commands.run(id);
}

void WelcomeView::draw_cards(ViewContext& context) {
  const float available = ImGui::GetContentRegionAvail().x;
  const int columns = std::clamp(static_cast<int>((available + kGap) / (kCardWidth * 0.8f + kGap)), 1, size_of(kSamples));
  const float width = std::floor((available - kGap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(kGap, kGap));
  for (int i = 0; i < size_of(kSamples); ++i) {
    if (i % columns != 0) ImGui::SameLine();
    draw_card(context, kSamples[idx(i)], ImVec2(width, kPictureHeight + kCardTextHeight));
  }
  ImGui::PopStyleVar();
}

void WelcomeView::draw_head(ViewContext& context, bool& open) {
  draw_overlay_title(context, "Welcome to Marey", "welcome.close", open);
  ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - kPadding);
  ui::dim_text(context, kPromise);
  ImGui::PopTextWrapPos();
  ImGui::Dummy(ImVec2(0.0f, 6.0f));
  ImGui::SetCursorPosX(kPadding);
  ui::command_button(context, "file.open", ui::ButtonLook::Primary, true, ".welcome");
  ImGui::SameLine(0.0f, 12.0f);
  ImGui::AlignTextToFramePadding();
  ui::dim_text(context, context.options.compact ? "or start with a sample:" : "or drop a .bvh anywhere, or start with a sample:");
  ImGui::Dummy(ImVec2(0.0f, 8.0f));
}

void WelcomeView::draw(ViewContext& context, bool& open) {
  const float top_share = context.options.compact ? 0.9f : 0.96f;
  begin_overlay(context, {"##welcome", wanted_size(context.options.compact), top_share}, open);
  draw_head(context, open);
  ImGui::SetCursorPosX(kPadding);
  ImGui::BeginChild("cards", ImVec2(ImGui::GetWindowWidth() - 2.0f * kPadding, ImGui::GetContentRegionAvail().y - 12.0f),
                    ImGuiChildFlags_NavFlattened);
  draw_cards(context);
  ImGui::EndChild();
  end_overlay();
  if (!context.system.reduced_motion) context.redraw = true;
}

}  // namespace marey::app
