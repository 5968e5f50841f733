#include "wasm/views/operations/operations_page.h"

#include <fmt/format.h>

#include "wasm/app/fuzzy_match.h"
#include "wasm/app/widgets.h"
#include "wasm/views/inspector/property_row.h"

namespace marey::app {
namespace {

constexpr float kRowHeight = 26.0f;

}  // namespace

void OperationsPage::open(const Operation& operation, Session& session, std::uint64_t clip_serial) {
  if (clip_serial_ != clip_serial) form_.forget();
  clip_serial_ = clip_serial;
  form_.cancel(session);
  form_.open(operation, session);
}

void OperationsPage::draw_row(ViewContext& context, const Operation& operation) {
  const SmallText id("operation.{}", operation.id);
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = context.options.touch ? ImGui::GetFrameHeight() : kRowHeight;
  const bool pressed = ImGui::InvisibleButton(id.c_str(), {width, height}, ImGuiButtonFlags_EnableNav);
  const ImVec2 min = ImGui::GetItemRectMin();
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (hovered) list.AddRectFilled(min, ImGui::GetItemRectMax(), context.theme.hovered);
  list.AddText({min.x + inspector::kPadding, min.y + 0.5f * (height - Fonts::kTextSize) - 1.0f}, context.theme.text,
               operation.label.data(), operation.label.data() + operation.label.size());
  context.items.add_last(id, operation.label);
  if (hovered) ui::tool_tip(context, operation.label, operation.help);
  if (pressed) open(operation, context.session, context.clip_serial);
}

void OperationsPage::draw_report(ViewContext& context) const {
  for (std::size_t i = 0; i < form_.report().size(); ++i) {
    ImGui::SetCursorPosX(inspector::kPadding);
    ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - inspector::kPadding);
    ImGui::PushStyleColor(ImGuiCol_Text, i == 0 ? context.theme.text : context.theme.dim_text);
    ImGui::TextUnformatted(form_.report()[i].c_str());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    context.items.add_last(SmallText("operation.report.{}", i), form_.report()[i]);
  }
}

void OperationsPage::draw_list(ViewContext& context) {
  ImGui::Dummy({0.0f, 8.0f});
  ImGui::SetCursorPosX(inspector::kPadding);
  ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x - inspector::kPadding);
  ui::search_field(context, "operations.search", "Find an operation", search_);
  ImGui::PopItemWidth();
  ImGui::Dummy({0.0f, 4.0f});
  draw_report(context);
  std::string_view group;
  for (const Operation& operation : operations()) {
    if (!search_.empty() && !find_fuzzy_match(search_, operation.label)) continue;
    if (operation.group != group) inspector::heading(context, operation.group);
    group = operation.group;
    draw_row(context, operation);
  }
  ImGui::Dummy({0.0f, 16.0f});
}

void OperationsPage::draw(ViewContext& context) {
  if (clip_serial_ != context.clip_serial) form_.forget();
  clip_serial_ = context.clip_serial;
  if (context.session.is_partial) {
    ImGui::SetCursorPos({inspector::kPadding, ImGui::GetCursorPosY() + 16.0f});
    ui::dim_text(context, "The file is still being read.");
    return;
  }
  if (form_.is_open()) {
    (void)form_.draw(context);
  } else {
    draw_list(context);
  }
}

}  // namespace marey::app
