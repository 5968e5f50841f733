#include "wasm/views/message_strip.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

constexpr float kPadding = 12.0f;
constexpr float kVerticalPadding = 10.0f;
constexpr float kLineGap = 4.0f;
constexpr float kTextIndent = kPadding + 28.0f;

struct KindLook {
  const char* icon;
  ImU32 color;
};

KindLook look_of(const Theme& theme, MessageKind kind) {
  switch (kind) {
    case MessageKind::Error: return {icons::kCircleAlert, theme.error};
    case MessageKind::Warning: return {icons::kTriangleAlert, theme.warning};
    case MessageKind::Note: break;
  }
  return {icons::kInfo, theme.accent};
}

float button_width(const ViewContext& context, const Message& message) {
  const Command* command = message.command.empty() ? nullptr : context.commands.find(message.command);
  return command == nullptr ? 0.0f : ImGui::CalcTextSize(command->label.c_str()).x + 56.0f;
}

float text_width(const ViewContext& context, const Message& message, float width) {
  const float free = width - kTextIndent - 2.0f * kPadding - ImGui::GetFrameHeight() - button_width(context, message);
  return std::max(free, 80.0f);
}

std::string waiting_text(const Messages& messages) {
  const int waiting = size_of(messages.list()) - 1;
  return waiting == 0 ? std::string() : fmt::format("{} more below this one", waiting);
}

}  // namespace

float MessageStrip::height(const ViewContext& context, const Messages& messages, float width) const {
  if (messages.list().empty()) return 0.0f;
  const Message& message = messages.list().front();
  const float wrap = text_width(context, message, width);
  float height = context.fonts.semibold->CalcTextSizeA(Fonts::kTextSize, wrap, wrap, message.title.c_str()).y;
  if (!message.detail.empty()) {
    height += kLineGap + context.fonts.text->CalcTextSizeA(Fonts::kTextSize, wrap, wrap, message.detail.c_str()).y;
  }
  if (messages.list().size() > 1) height += kLineGap + Fonts::kTextSize;
  return std::ceil(std::max(height, ImGui::GetFrameHeight() - 8.0f) + 2.0f * kVerticalPadding);
}

void MessageStrip::draw(ViewContext& context, Messages& messages) {
  if (messages.list().empty()) return;
  const Message& message = messages.list().front();
  const KindLook look = look_of(context.theme, message.kind);
  const ImVec2 min = ImGui::GetWindowPos();
  const ImVec2 max(min.x + ImGui::GetWindowWidth(), min.y + ImGui::GetWindowHeight());
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  draw_list.AddRectFilled(min, max, with_alpha(look.color, 0.1f));
  draw_list.AddRectFilled(min, ImVec2(min.x + 3.0f, max.y), look.color);
  draw_list.AddText(ImVec2(min.x + kPadding + 2.0f, min.y + kVerticalPadding), look.color, look.icon);

  const float width = ImGui::GetWindowWidth();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8.0f, kLineGap));
  ImGui::SetCursorPos(ImVec2(kTextIndent, kVerticalPadding));
  ImGui::BeginGroup();
  ImGui::PushTextWrapPos(kTextIndent + text_width(context, message, width));
  ImGui::PushFont(context.fonts.semibold, 0.0f);
  ImGui::TextUnformatted(message.title.c_str());
  ImGui::PopFont();
  if (!message.detail.empty()) ImGui::TextUnformatted(message.detail.c_str());
  if (const std::string waiting = waiting_text(messages); !waiting.empty()) ui::dim_text(context, waiting);
  ImGui::PopTextWrapPos();
  ImGui::EndGroup();
  context.items.add_last("message.text", message.title + " " + message.detail);
  ImGui::PopStyleVar();

  const float close_x = width - kPadding - ImGui::GetFrameHeight();
  bool close = false;
  if (!message.command.empty()) {
    ImGui::SetCursorPos(ImVec2(close_x - button_width(context, message), kVerticalPadding - 4.0f));
    close = ui::command_button(context, message.command, ui::ButtonLook::Raised, true, ".message");
  }
  ImGui::SetCursorPos(ImVec2(close_x, kVerticalPadding - 6.0f));
  if (ui::icon_button(context, "message.close", icons::kX, "Close this message") || close) messages.close(0);
}

}  // namespace marey::app
