#include <imgui_internal.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "core/text/character_set.h"
#include "wasm/app/icons.h"
#include "wasm/app/shortcut.h"
#include "wasm/app/widgets.h"

namespace marey::app::ui {
namespace {

constexpr float kTipWidth = 280.0f;
constexpr std::string_view kEllipsis = "…";

float text_width(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; }

bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

std::size_t character_start(std::string_view text, std::size_t position) {
  while (position > 0 && position < text.size() && is_continuation(text[position])) --position;
  return position;
}

SmallText cut_in_the_middle(std::string_view text, std::size_t kept) {
  const std::size_t head = character_start(text, (kept + 1) / 2);
  std::size_t tail = text.size() - kept / 2;
  while (tail < text.size() && is_continuation(text[tail])) ++tail;
  return SmallText("{}{}{}", text.substr(0, head), kEllipsis, text.substr(tail));
}

// The longest cut that fits; wider texts have wider cuts, so the number of kept bytes is found by bisection.
SmallText fitted(std::string_view text, float width) {
  std::size_t fits = 0;
  std::size_t too_many = text.size();
  while (too_many - fits > 1) {
    const std::size_t middle = (fits + too_many) / 2;
    (text_width(cut_in_the_middle(text, middle)) <= width ? fits : too_many) = middle;
  }
  return cut_in_the_middle(text, fits);
}

// ImGui hides a new window for a frame, in which it learns its size.
bool begin_tip(ViewContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10, 8));
  const bool open = ImGui::BeginTooltip();
  ImGui::PopStyleVar();
  if (!open) return false;
  popup_shadow(context);
  if (ImGui::GetCurrentWindow()->Hidden) context.redraw = true;
  return true;
}

void draw_tip(ViewContext& context, std::string_view name, std::string_view help, std::string_view shortcut,
              std::string_view reason) {
  if (!begin_tip(context)) return;
  ImGui::PushFont(context.fonts.semibold, 0.0f);
  ImGui::TextUnformatted(name.data(), name.data() + name.size());
  ImGui::PopFont();
  if (const std::string keys = displayed_shortcut(shortcut, context.system.apple_keys); !keys.empty()) {
    ImGui::SameLine(0.0f, 16.0f);
    dim_text(context, keys);
  }
  ImGui::PushTextWrapPos(kTipWidth);
  if (!help.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.dim_text);
    ImGui::TextUnformatted(help.data(), help.data() + help.size());
    ImGui::PopStyleColor();
  }
  if (!reason.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.warning);
    ImGui::TextUnformatted(reason.data(), reason.data() + reason.size());
    ImGui::PopStyleColor();
  }
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

// Asks for frames while the delay runs, since an idle page draws none.
bool wants_tip(ViewContext& context) {
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip)) return !ImGui::IsItemActive();
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) context.redraw = true;
  return false;
}

}  // namespace

void tool_tip(ViewContext& context, std::string_view name, std::string_view help, std::string_view shortcut) {
  if (wants_tip(context)) draw_tip(context, name, help, shortcut, {});
}

void command_tool_tip(ViewContext& context, const Command& command) {
  if (!wants_tip(context)) return;
  draw_tip(context, CommandRegistry::label_of(command), command.help, command.shortcut,
           CommandRegistry::blocked_reason(command));
}

bool search_field(ViewContext& context, const char* id, std::string_view hint, std::string& text) {
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float width = ImGui::CalcItemWidth();
  const float height = ImGui::GetFrameHeight();
  const float clear_width = text.empty() ? 0.0f : height;
  const SmallText empty_hint("{}", hint);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(30.0f, ImGui::GetStyle().FramePadding.y));
  ImGui::SetNextItemWidth(width - clear_width);
  bool changed = ImGui::InputTextWithHint(SmallText("##{}", id).c_str(), empty_hint.c_str(), &text,
                                          ImGuiInputTextFlags_EscapeClearsAll);
  ImGui::PopStyleVar();
  const bool focused = ImGui::IsItemActive();
  context.items.add_last(id, empty_hint);
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const ImVec2 end(start.x + width, start.y + height);
  draw_list.AddText(ImVec2(start.x + 8.0f, start.y + std::round((height - Fonts::kTextSize) * 0.5f)),
                    context.theme.dim_text, icons::kSearch);
  if (clear_width > 0.0f) {
    ImGui::SameLine(0.0f, 0.0f);
    if (icon_button(context, SmallText("{}.clear", id).c_str(), icons::kX, "Clear the search")) {
      text.clear();
      changed = true;
    }
  }
  draw_list.AddRect(start, end, focused ? context.theme.accent : context.theme.line, 4.0f, 0,
                    focused ? 1.5f : device_pixel());
  return changed;
}

bool text_field(ViewContext& context, const char* id, std::string_view label, std::string_view tip, std::string& text,
                float width) {
  const ImVec2 start = ImGui::GetCursorScreenPos();
  ImGui::SetNextItemWidth(width);
  const bool changed = ImGui::InputText(SmallText("##{}", id).c_str(), &text);
  const bool focused = ImGui::IsItemActive();
  context.items.add_last(id, label);
  tool_tip(context, label, tip);
  ImGui::GetWindowDrawList()->AddRect(start, ImVec2(start.x + width, start.y + ImGui::GetFrameHeight()),
                                      focused ? context.theme.accent : context.theme.line, 4.0f, 0,
                                      focused ? 1.5f : device_pixel());
  return changed;
}

void panel_title(ViewContext& context, std::string_view title) {
  const ImVec2 start = ImGui::GetCursorScreenPos();
  constexpr float kRow = 32.0f;
  constexpr float kIndent = 12.0f;
  const float y = std::round(start.y + (kRow - Fonts::kTitleSize) * 0.5f);
  ImGui::GetWindowDrawList()->AddText(context.fonts.semibold, Fonts::kTitleSize, ImVec2(start.x + kIndent, y), context.theme.text,
                                      title.data(), title.data() + title.size());
  ImGui::Dummy(ImVec2(0.0f, kRow));
}

void dim_text(const ViewContext& context, std::string_view text) {
  ImGui::PushStyleColor(ImGuiCol_Text, context.theme.dim_text);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopStyleColor();
}

void elided_text(ViewContext& context, std::string_view text, float width, ImU32 color) {
  const bool fits = text_width(text) <= width;
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  if (fits) {
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
  } else {
    const SmallText shown = fitted(text, width);
    ImGui::TextUnformatted(shown.c_str());
  }
  ImGui::PopStyleColor();
  if (!fits) tool_tip(context, text, {});
}

float device_pixel() { return 1.0f / std::max(ImGui::GetIO().DisplayFramebufferScale.x, 0.25f); }

void hairline(ImDrawList& draw_list, ImVec2 from, ImVec2 to, ImU32 color) {
  const float pixel = device_pixel();
  const auto snapped = [pixel](float value) { return std::round(value / pixel) * pixel; };
  const ImVec2 min(snapped(std::min(from.x, to.x)), snapped(std::min(from.y, to.y)));
  const ImVec2 max(snapped(std::max(from.x, to.x)), snapped(std::max(from.y, to.y)));
  draw_list.AddRectFilled(min, ImVec2(std::max(max.x, min.x + pixel), std::max(max.y, min.y + pixel)), color);
}

void popup_shadow(const ViewContext& context) {
  constexpr int kRings = 14;
  const float strength = context.theme.kind == ThemeKind::Dark ? 0.34f : 0.13f;
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const ImVec2 min = ImGui::GetWindowPos();
  const ImVec2 max(min.x + ImGui::GetWindowWidth(), min.y + ImGui::GetWindowHeight());
  draw_list.PushClipRectFullScreen();
  for (int ring = 1; ring <= kRings; ++ring) {
    const auto reach = static_cast<float>(ring);
    const float fade = 1.0f - reach / static_cast<float>(kRings + 1);
    draw_list.AddRect(ImVec2(min.x - reach, min.y - reach * 0.6f), ImVec2(max.x + reach, max.y + reach * 1.4f),
                      with_alpha(IM_COL32_BLACK, strength * fade * fade), ImGui::GetStyle().PopupRounding + reach, 0, 1.5f);
  }
  draw_list.PopClipRect();
}

std::string displayable(std::string_view bytes) { return decoded(bytes, CharacterSet::Utf8); }

}  // namespace marey::app::ui
