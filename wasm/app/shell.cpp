#include "wasm/app/shell.h"

#include <algorithm>

#include "wasm/app/widgets.h"
#include "wasm/views/sheet_tabs.h"
#include "wasm/views/viewport/performance_card.h"

namespace marey::app {
namespace {

constexpr float kSplitterReach = 8.0f;

// Where a region meets the one before it, it draws a hairline.
enum Edge : unsigned { kNoEdge = 0, kTop = 1, kLeft = 2, kRight = 4 };

struct Place {
  const char* id;
  const Region& region;
  ImU32 ground;  ///< 0: what lies behind shows through
  unsigned edges = kNoEdge;
};

void draw_edges(const ViewContext& context, const Place& place) {
  ImDrawList& lines = *ImGui::GetWindowDrawList();
  const ImVec2 min = place.region.min;
  const ImVec2 max = place.region.max;
  const float right = max.x - ui::device_pixel();
  if ((place.edges & kTop) != 0) ui::hairline(lines, min, ImVec2(max.x, min.y), context.theme.line);
  if ((place.edges & kLeft) != 0) ui::hairline(lines, min, ImVec2(min.x, max.y), context.theme.line);
  if ((place.edges & kRight) != 0) ui::hairline(lines, ImVec2(right, min.y), ImVec2(right, max.y), context.theme.line);
}

// One view in its region: a child window that shares ImGui's keyboard focus with the others.
template <class Draw>
void draw_region(const ViewContext& context, const Place& place, const Draw& draw) {
  const Region& region = place.region;
  if (region.empty()) return;
  ImGui::GetWindowDrawList()->AddRectFilled(region.min, region.max, place.ground);
  ImGui::SetCursorScreenPos(region.min);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::BeginChild(place.id, ImVec2(region.width(), region.height()), ImGuiChildFlags_NavFlattened,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  draw();
  draw_edges(context, place);
  ImGui::SetCursorScreenPos(region.min);  // the view may have left the cursor anywhere; its region is what it is
  ImGui::EndChild();
}

// By reference: an std::function with more than that takes memory, and this is done in each frame.
template <class Draw>
void draw_panel(ViewContext& context, PanelGuards& guards, const Place& place, std::string_view name, const Draw& draw) {
  draw_region(context, place, [&] { guards.draw(context, place.id, name, std::ref(draw)); });
}

struct Splitter {
  const char* id;
  const char* tip;
  bool vertical;     ///< a vertical bar that moves sideways
  ImVec2 from, to;   ///< the border that it moves
  float sign;        ///< +1: moving right or down makes the panel larger
  float usual;       ///< the size that a double click brings back
  SplitterLimits limits;
};

void draw_splitter(ViewContext& context, const Splitter& splitter, float& size) {
  const float reach = kSplitterReach * 0.5f;
  const ImVec2 grow = splitter.vertical ? ImVec2(reach, 0.0f) : ImVec2(0.0f, reach);
  const ImVec2 min(splitter.from.x - grow.x, splitter.from.y - grow.y);
  const ImVec2 max(splitter.to.x + grow.x, splitter.to.y + grow.y);
  const Region region{min, max};
  draw_region(context, {splitter.id, region, 0}, [&] {
    ImGui::InvisibleButton("bar", ImVec2(max.x - min.x, max.y - min.y));
    context.items.add_last(splitter.id, splitter.tip);
    const bool touched = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (ImGui::IsItemActive()) {
      const ImVec2 moved = ImGui::GetIO().MouseDelta;
      const float wanted = size + splitter.sign * (splitter.vertical ? moved.x : moved.y);
      size = std::clamp(wanted, splitter.limits.low, std::max(splitter.limits.low, splitter.limits.high));
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) size = splitter.usual;
    if (!touched) return;
    ImGui::SetMouseCursor(splitter.vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    ImGui::GetWindowDrawList()->AddLine(splitter.from, splitter.to, context.theme.accent, 2.0f);
    context.status = "Drag to resize the panel. Double click for its usual size.";
  });
}

void draw_splitters(ViewContext& context, const Layout& layout, PanelSizes& sizes) {
  if (layout.compact) return;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const PanelSizes usual;
  if (!layout.outliner.empty()) {
    const Region& region = layout.outliner;
    draw_splitter(context,
                  {"splitter.outliner", "Width of the joints", true, ImVec2(region.max.x, region.min.y), region.max, 1.0f,
                   usual.outliner_width, outliner_limits(size)},
                  sizes.outliner_width);
  }
  if (!layout.inspector.empty()) {
    const Region& region = layout.inspector;
    draw_splitter(context,
                  {"splitter.inspector", "Width of the inspector", true, region.min, ImVec2(region.min.x, region.max.y),
                   -1.0f, usual.inspector_width, inspector_limits(size)},
                  sizes.inspector_width);
  }
  if (!layout.curves.empty()) {
    const Region& region = layout.transport;
    draw_splitter(context,
                  {"splitter.curves", "Height of the curves", false, region.min, ImVec2(region.max.x, region.min.y), -1.0f,
                   usual.curves_height, curves_limits(size)},
                  sizes.curves_height);
  }
}

}  // namespace

void Shell::add_commands(CommandRegistry& registry, Workspace& workspace, TimeWindow& time_window) {
  viewport_.add_commands(registry, workspace.session);
  curves_.add_commands(registry, workspace.session, workspace.preferences.options, time_window);
  inspector_.add_commands(registry, workspace);
  add_analysis_commands(registry, workspace);
}

void Shell::document_opened() {
  outliner_.document_opened();
  curves_.document_opened();
  viewport_.document_opened();
}

void Shell::draw_bars(ViewContext& context, Workspace& workspace, const Layout& layout) {
  const ImU32 panel = context.theme.panel;
  draw_panel(context, guards_, {"title", layout.title, panel}, "title bar", [&] { title_bar_.draw(context, layout.compact); });
  draw_strips(context, workspace, layout.messages);
  draw_panel(context, guards_, {"sheets", layout.sheet_header, panel, kTop}, "tabs", [&] { draw_sheet_tabs(context); });
}

void Shell::draw_strips(ViewContext& context, Workspace& workspace, const Region& region) {
  const ImU32 panel = context.theme.panel;
  const float border = region.min.y + loading_strip_.height(context, workspace.loading.get());
  const Region loading{region.min, ImVec2(region.max.x, std::min(border, region.max.y))};
  const Region messages{ImVec2(region.min.x, border), region.max};
  draw_panel(context, guards_, {"loading", loading, panel, kTop}, "progress",
             [&] { loading_strip_.draw(context, *workspace.loading); });
  draw_panel(context, guards_, {"messages", messages, panel, kTop}, "messages",
             [&] { message_strip_.draw(context, workspace.messages); });
}

void Shell::draw_side_panels(ViewContext& context, const Layout& layout) {
  const ImU32 panel = context.theme.panel;
  const unsigned side = layout.compact ? kNoEdge : kTop;
  draw_panel(context, guards_, {"outliner", layout.outliner, panel, layout.compact ? side : side | kRight}, "list of joints",
             [&] { outliner_.draw(context); });
  draw_panel(context, guards_, {"inspector", layout.inspector, panel, layout.compact ? side : side | kLeft}, "inspector",
             [&] { inspector_.draw(context); });
}

void Shell::draw_time_panels(ViewContext& context, const Layout& layout) {
  const ImU32 panel = context.theme.panel;
  draw_panel(context, guards_, {"transport", layout.transport, panel, kTop}, "transport", [&] { transport_.draw(context); });
  draw_panel(context, guards_, {"ruler", layout.ruler, panel, kTop}, "ruler", [&] { timeline_.draw(context); });
  draw_panel(context, guards_, {"curves", layout.curves, panel}, "curve editor", [&] { curves_.draw(context, inspector_.operation_form()); });
}

Layout Shell::lay_out(ViewContext& context, Workspace& workspace) {
  const ViewOptions& options = workspace.preferences.options;
  const double elapsed_s = static_cast<double>(ImGui::GetIO().DeltaTime);
  const bool at_once = context.system.reduced_motion || options.compact;
  const auto move = [&](Transition& transition, bool shown) {
    if (transition.advance(shown, elapsed_s, at_once)) context.redraw = true;
    return transition.share();
  };
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  return compute_layout({.size = size,
                         .messages_height = loading_strip_.height(context, workspace.loading.get()) +
                                            message_strip_.height(context, workspace.messages, size.x),
                         .touch = options.touch,
                         .outliner_share = move(outliner_opening_, options.show_outliner),
                         .inspector_share = move(inspector_opening_, options.show_inspector),
                         .curves_share = move(curves_opening_, options.show_curves),
                         .preferences = &workspace.preferences});
}

void Shell::tell_faults(Workspace& workspace) {
  for (const PanelGuards::Report& report : guards_.take_reports()) {
    workspace.backend.report_fault(report.sentence + " " + report.details);
    workspace.notify(report.sentence);
  }
}

void Shell::draw(ViewContext& context, Workspace& workspace, Scene& scene) {
  Preferences& preferences = workspace.preferences;
  const Layout layout = lay_out(context, workspace);
  if (workspace.problems_wanted) inspector_.show(InspectorView::Page::Problems);
  workspace.problems_wanted = false;

  draw_bars(context, workspace, layout);
  draw_side_panels(context, layout);
  draw_time_panels(context, layout);
  draw_panel(context, guards_, {"viewport", layout.viewport, 0, kTop}, "view of the figure", [&] {
    viewport_.draw(context, scene);
    if (!preferences.options.show_performance) return;
    draw_performance_card(context, workspace.performance, layout.viewport.min, {layout.viewport.width(), layout.viewport.height()});
  });
  draw_splitters(context, layout, preferences.sizes);
  tell_faults(workspace);
}

}  // namespace marey::app
