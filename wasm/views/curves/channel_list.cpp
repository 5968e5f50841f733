#include "wasm/views/curves/channel_list.h"

#include <fmt/format.h>

#include <string>

#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"
#include "wasm/views/curves/curves_drawing.h"
#include "wasm/views/curves/curves_state.h"
#include "wasm/views/graph/ticks.h"

namespace marey::app {
namespace {

constexpr float kRowHeight = 22.0f;
constexpr float kPadding = 10.0f;
constexpr float kSwatch = 8.0f;
constexpr float kEyeWidth = 20.0f;

void draw_row_texts(ViewContext& context, ChannelIndex index, ImVec2 min, float width) {
  const Document& document = context.session.document;
  const Channel& channel = document.skeleton().channel(index);
  const bool visible = context.session.selection.is_channel_visible(index);
  const ImU32 color = with_alpha(channel_color(context.theme, channel), visible ? 1.0f : 0.35f);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float middle = min.y + 0.5f * kRowHeight;
  list.AddRectFilled({min.x + kPadding, middle - 0.5f * kSwatch}, {min.x + kPadding + kSwatch, middle + 0.5f * kSwatch},
                     color, 2.0f);
  const ImU32 text_color = visible ? context.theme.text : context.theme.dim_text;
  list.AddText({min.x + kPadding + kSwatch + 8.0f, middle - 0.5f * ImGui::GetFontSize()}, text_color,
               short_name_of(channel));
  if (document.motion().frame_count() == 0) return;
  const bool angle = is_rotation(channel.kind);
  const double value = document.motion().sample(index, context.session.playback.frame());
  const std::string text = fmt::format("{}{}", tick_label(value, angle ? 2 : 3), angle ? "°" : "");
  const float size = Fonts::kSmallSize + 1.0f;
  const float text_width = context.fonts.mono->CalcTextSizeA(size, FLT_MAX, 0.0f, text.c_str()).x;
  list.AddText(context.fonts.mono, size, {min.x + width - kEyeWidth - 8.0f - text_width, middle - 0.5f * size - 1.0f},
               text_color, text.c_str());
}

void draw_row(ViewContext& context, ChannelIndex index) {
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  Selection& selection = context.session.selection;
  const bool visible = selection.is_channel_visible(index);
  const SmallText id("curves.channel.{}", index);
  if (ImGui::InvisibleButton(id.c_str(), {width, kRowHeight})) selection.set_channel_visible(index, !visible);
  const Skeleton& skeleton = context.session.document.skeleton();
  const Channel& channel = skeleton.channel(index);
  context.items.add_last(id, SmallText("{} {}", skeleton.name(channel.joint), channel_name(channel)));
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (hovered || context.hover.channel == index) {
    list.AddRectFilled(min, {min.x + width, min.y + kRowHeight}, context.theme.hovered);
  }
  if (hovered) {
    context.next_hover.channel = index;
    ui::tool_tip(context, channel_label(skeleton, index),
                 visible ? "Click to hide this curve." : "Click to show this curve.");
  }
  draw_row_texts(context, index, min, width);
  const char* icon = visible ? icons::kEye : icons::kEyeOff;
  list.AddText({min.x + width - kEyeWidth - 2.0f, min.y + 0.5f * (kRowHeight - ImGui::GetFontSize())},
               hovered || !visible ? context.theme.text : context.theme.dim_text, icon);
}

// Rows out of sight are left out, but for some beside those in sight, where the arrow keys go on.
bool is_near_sight(float height) {
  const float top = ImGui::GetCursorScreenPos().y;
  const float window_top = ImGui::GetWindowPos().y;
  constexpr float kMargin = 2.0f * kRowHeight;
  return top + height >= window_top - kMargin && top <= window_top + ImGui::GetWindowHeight() + kMargin;
}

void draw_joint_heading(ViewContext& context, JointIndex joint) {
  ImGui::Dummy({0.0f, 4.0f});
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + kPadding);
  const float width = ImGui::GetContentRegionAvail().x - kPadding;
  ui::elided_text(context, context.session.document.skeleton().name(joint), width,
                  context.theme.dim_text);
  ImGui::Dummy({0.0f, 4.0f});
}

}  // namespace

void draw_channel_list(ViewContext& context) {
  const Skeleton& skeleton = context.session.document.skeleton();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, 0.0f});
  for (const JointIndex joint : context.session.selection.joints()) {
    draw_joint_heading(context, joint);
    const ChannelIndex first = skeleton.first_channel(joint);
    for (int i = 0; i < skeleton.channel_count(joint); ++i) {
      is_near_sight(kRowHeight) ? draw_row(context, first + i) : ImGui::Dummy({0.0f, kRowHeight});
    }
  }
  ImGui::PopStyleVar();
}

}  // namespace marey::app
