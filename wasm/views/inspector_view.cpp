#include "wasm/views/inspector_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "wasm/app/builtin_commands.h"
#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"
#include "wasm/views/analysis/body_page.h"
#include "wasm/views/inspector/clip_page.h"

namespace marey::app {
namespace {

constexpr float kTabHeight = 36.0f;
constexpr float kTabPadding = 8.0f;
constexpr float kLeastTabPadding = 3.0f;

int problem_count(const Diagnostics& diagnostics) {
  return diagnostics.count(Severity::Warning) + diagnostics.count(Severity::Error);
}

}  // namespace

void InspectorView::draw_tab(ViewContext& context, const Tab& tab, float padding) {
  const bool active = tab.page == page_;
  const std::string_view label = tab.label;
  ImGui::PushFont(context.fonts.semibold, Fonts::kTextSize);
  const ImVec2 text = ImGui::CalcTextSize(label.data(), label.data() + label.size());
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 max{min.x + text.x + 2.0f * padding, min.y + kTabHeight};
  if (ImGui::InvisibleButton(tab.id, {max.x - min.x, kTabHeight})) page_ = tab.page;
  context.items.add_last(tab.id, label);
  const ImU32 color = active || ImGui::IsItemHovered() ? context.theme.text : context.theme.dim_text;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText({min.x + padding, min.y + 0.5f * (kTabHeight - text.y)}, color, label.data(), label.data() + label.size());
  if (active) list.AddRectFilled({min.x + padding, max.y - 2.0f}, {max.x - padding, max.y}, context.theme.accent, 1.0f);
  ImGui::PopFont();
}

void InspectorView::draw_tabs(ViewContext& context) {
  const int problems = problem_count(context.session.document.diagnostics());
  const SmallText problem_label = problems > 0 ? SmallText("Problems ({})", problems) : SmallText("Problems");
  const std::array<Tab, 6> tabs = {Tab{Page::Joint, "inspector.tab.joint", "Joint"},    Tab{Page::Clip, "inspector.tab.clip", "Clip"},
                                   Tab{Page::Edit, "inspector.tab.edit", "Edit"},       Tab{Page::Layers, "inspector.tab.layers", "Layers"},
                                   Tab{Page::Body, "inspector.tab.body", "Body"},       Tab{Page::Problems, "inspector.tab.problems", problem_label}};
  ImGui::PushFont(context.fonts.semibold, Fonts::kTextSize);
  float text_width = 0.0f;
  for (const Tab& tab : tabs) text_width += ImGui::CalcTextSize(tab.label.data(), tab.label.data() + tab.label.size()).x;
  ImGui::PopFont();
  const float room = ImGui::GetContentRegionAvail().x - 4.0f - text_width;
  const float padding = std::clamp(std::floor(0.5f * room / static_cast<float>(tabs.size())), kLeastTabPadding, kTabPadding);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 2.0f);
  for (const Tab& tab : tabs) {
    draw_tab(context, tab, padding);
    ImGui::SameLine(0.0f, 0.0f);
  }
  ImGui::NewLine();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddLine(at, {at.x + ImGui::GetContentRegionAvail().x, at.y}, context.theme.line);
}

void InspectorView::add_commands(CommandRegistry& registry, Workspace& workspace) {
  const auto show_page = [this, &workspace](Page page) {
    page_ = page;
    workspace.preferences.options.show_inspector = true;
    workspace.preferences.sheet = Sheet::Inspector;
  };
  for (const Operation& operation : operations()) {
    registry.add({.id = fmt::format("operation.{}", operation.id),
                  .label = fmt::format("{}…", operation.label),
                  .help = std::string(operation.help),
                  .icon = icons::kPencil,
                  .run = [this, &workspace, &operation, show_page](const nlohmann::json&) -> nlohmann::json {
                    show_page(Page::Edit);
                    operations_.open(operation, workspace.session, workspace.clip_serial);
                    return nullptr;
                  },
                  .blocked = [&workspace] { return needs_whole_clip(workspace); }});
  }
  registry.add({.id = "view.layers",
                .label = "Layers",
                .help = "Shows the layers of keys.",
                .shortcut = "Shift+L",
                .icon = icons::kLayers,
                .run = [show_page](const nlohmann::json&) -> nlohmann::json {
                  show_page(Page::Layers);
                  return nullptr;
                }});
  registry.add({.id = "analysis.body",
                .label = "Body and smoothing",
                .help = "Shows the masses of the figure, what holds it, and how samples are smoothed.",
                .shortcut = "Shift+B",
                .icon = icons::kWeight,
                .run = [show_page](const nlohmann::json&) -> nlohmann::json {
                  show_page(Page::Body);
                  return nullptr;
                }});
  add_layer_commands(registry, workspace);
}

void InspectorView::draw(ViewContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, 0.0f});
  draw_tabs(context);
  if (page_ != Page::Edit) operations_.leave(context.session);
  ImGui::BeginChild("inspector.page", {0.0f, 0.0f});
  switch (page_) {
    case Page::Joint: joint_page_.draw(context); break;
    case Page::Clip: draw_clip_page(context); break;
    case Page::Edit: operations_.draw(context); break;
    case Page::Layers: layers_.draw(context); break;
    case Page::Body: draw_body_page(context); break;
    case Page::Problems: problems_.draw(context); break;
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace marey::app
