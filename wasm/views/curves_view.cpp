#include "wasm/views/curves_view.h"

#include <array>
#include <string>

#include "wasm/app/widgets.h"
#include "wasm/views/curves/channel_list.h"
#include "wasm/views/curves/curve_commands.h"
#include "wasm/views/curves/curves_input.h"
#include "wasm/views/time_gutter.h"

namespace marey::app {
namespace {

constexpr float kBottomMargin = 8.0f;
constexpr std::array kPages = {"view.curve_editor", "view.filter_explorer", "view.rotation_orders", "view.plots"};

float pages_width() { return (ImGui::GetFrameHeight() + 2.0f) * static_cast<float>(kPages.size()) + 18.0f; }

void draw_joint_choice(ViewContext& context) {
  Selection& selection = context.session.selection;
  if (context.session.document.skeleton().joint_count() == 0) return;
  if (ui::text_button(context, "curves.select_root", "Select the root", "Select the root joint to see its curves.")) {
    selection.select_only(0);
  }
}

}  // namespace

void CurvesView::add_commands(CommandRegistry& registry, Session& session, ViewOptions& options, TimeWindow& time) {
  add_curve_commands(registry, {session, options, time, state_});
}

void CurvesView::place_axes(ViewContext& context, ImVec2 origin, ImVec2 size) {
  state_.area.min = {context.time_window.left, origin.y};
  state_.area.max = {context.time_window.right, origin.y + size.y - kBottomMargin};
  for (ValueAxis* axis : {&state_.angles, &state_.lengths}) {
    axis->top = state_.area.min.y;
    axis->bottom = state_.area.max.y;
  }
}

void CurvesView::draw_gutters(ViewContext& context) {
  const float gutter = kAxisGutter - 2.0f;
  const float height = state_.area.max.y - state_.area.min.y;
  ImGui::SetCursorScreenPos({state_.area.min.x - gutter - 2.0f, state_.area.min.y});
  ImGui::InvisibleButton("curves.axis.left", {gutter, height});
  context.items.add_last("curves.axis.left", "Value axis");
  handle_axis_input(context, state_.shows_angles ? state_.angles : state_.lengths);
  if (!state_.shows_angles || !state_.shows_lengths) return;
  ImGui::SetCursorScreenPos({state_.area.max.x + 2.0f, state_.area.min.y});
  ImGui::InvisibleButton("curves.axis.right", {gutter, height});
  context.items.add_last("curves.axis.right", "Position axis");
  handle_axis_input(context, state_.lengths);
}

void CurvesView::draw_canvas(ViewContext& context) {
  ImGui::SetCursorScreenPos(state_.area.min);
  const ImVec2 size{state_.area.max.x - state_.area.min.x, state_.area.max.y - state_.area.min.y};
  ImGui::InvisibleButton(
      "curves.canvas", size,
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle | ImGuiButtonFlags_MouseButtonRight);
  context.items.add_last("curves.canvas", "Curves");
  handle_curves_input(context, state_);
  drawing_.draw(context, state_);
  draw_gutters(context);
}

void CurvesView::draw_empty(ViewContext& context) const {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const char* text = "Select a joint in the figure or the outliner to see its curves.";
  const float width = ImGui::CalcTextSize(text).x;
  ImGui::SetCursorPos({ImGui::GetCursorPosX() + 0.5f * (room.x - width), ImGui::GetCursorPosY() + 0.35f * room.y});
  ui::dim_text(context, text);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.5f * (room.x - 120.0f));
  draw_joint_choice(context);
}

// At the right end of the row above the curves, on each page at the same place.
void CurvesView::draw_pages(ViewContext& context, ImVec2 corner, ImVec2 room) const {
  const float button = ImGui::GetFrameHeight();
  ImGui::SetCursorScreenPos({corner.x + room.x - (button + 2.0f) * static_cast<float>(kPages.size()) - 8.0f, corner.y + 4.0f});
  for (const char* id : kPages) {
    ui::command_button(context, id);
    ImGui::SameLine(0.0f, 2.0f);
  }
  ImGui::NewLine();
}

void CurvesView::draw(ViewContext& context, const OperationForm& form) {
  if (update_shown_channels(state_, context.session)) fit_values(state_, context.session, context.time_window);
  const CurvesPage page = context.options.curves_page;
  const bool has_frames = context.session.document.motion().frame_count() > 0;
  if (!has_frames || (context.session.selection.joints().empty() && page != CurvesPage::Plots)) {
    draw_empty(context);
    return;
  }
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 end{corner.x + room.x, corner.y + room.y};
  if (page == CurvesPage::Plots) plots_.draw(context, corner, end, pages_width());
  if (page == CurvesPage::Orders) orders_.draw(context, corner, end);
  if (page == CurvesPage::Filter && !state_.shown.empty()) explorer_.draw(context, form, state_.shown, corner, end);
  if (page == CurvesPage::Curves) draw_curves(context);
  draw_pages(context, corner, room);
}

void CurvesView::draw_curves(ViewContext& context) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float list_width = context.options.compact ? 0.0f : kChannelListWidth;
  if (list_width > 0.0f) {
    ImGui::BeginChild("curves.channels", {list_width, room.y});
    draw_channel_list(context);
    ImGui::EndChild();
  }
  ImGui::SetCursorScreenPos({corner.x + list_width + 8.0f, corner.y + 4.0f});
  ImGui::BeginChild("curves.toolbar", {room.x - list_width - 8.0f - pages_width(), CurvesToolbar::height()}, ImGuiChildFlags_None,
                    ImGuiWindowFlags_NoScrollbar);
  toolbar_.draw(context, state_);
  ImGui::EndChild();
  const float used = CurvesToolbar::height() + 8.0f;
  if (room.y - used < 40.0f) return;
  place_axes(context, {corner.x, corner.y + used}, {room.x, room.y - used});
  draw_canvas(context);
}

}  // namespace marey::app
