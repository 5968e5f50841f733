#include "wasm/views/analysis/plot_buttons.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"

namespace marey::app {
namespace {

constexpr const char* kFrameList = "plots.frames";
constexpr const char* kPlotMenu = "plots.menu";
constexpr float kTouchSpacing = 18.0f;

// The frames of reference that a plot can be seen from, as lines of an open popup; whether one was chosen.
bool draw_frames(ViewContext& context, const AnalysisPlot& plot, std::string& frame) {
  const std::string before = frame;
  const auto add = [&](const std::string& value, const char* label) {
    if (ImGui::Selectable(label, frame == value)) frame = value;
    context.items.add_last(SmallText("plots.frame.{}", value), label);
  };
  add("", "As usual");
  add("world", "World");
  add("root", "Root");
  if (plot.node != kNoParent) add("parent", "Parent");
  ImGui::Separator();
  const Skeleton& skeleton = context.session.document.skeleton();
  for (JointIndex joint = 0; joint < skeleton.joint_count(); ++joint) {
    ImGui::PushID(joint);
    add(skeleton.name(joint), ui::displayable(skeleton.name(joint)).c_str());
    ImGui::PopID();
  }
  return frame != before;
}

// The chosen one, in the frame of the click.
std::optional<std::string> draw_frame_list(ViewContext& context, const AnalysisPlot& plot) {
  if (!ImGui::BeginPopup(kFrameList)) return std::nullopt;
  ui::popup_shadow(context);
  std::string frame = plot.choice.frame;
  const bool is_chosen = draw_frames(context, plot, frame);
  ImGui::EndPopup();
  return is_chosen ? std::optional(std::move(frame)) : std::nullopt;
}

bool can_be_pinned(const AnalysisPlot& plot) { return is_of_joint(*plot.choice.quantity) && plot.node != kNoParent; }
bool can_be_seen_from(const AnalysisPlot& plot) { return plot.choice.quantity->sight != QuantitySight::None; }

void replace_choice(ViewContext& context, int index, PlotChoice choice) {
  std::vector<PlotChoice> choices = context.analysis.choices();
  choices[idx(index)] = std::move(choice);
  context.analysis.set_choices(std::move(choices));
  context.redraw = true;
}

void toggle_pin(ViewContext& context, const AnalysisPlot& plot, int index) {
  PlotChoice choice = plot.choice;
  choice.owner = choice.owner.empty() ? plot.owner : std::string();
  replace_choice(context, index, std::move(choice));
}

void see_from(ViewContext& context, const AnalysisPlot& plot, int index, std::string frame) {
  PlotChoice choice = plot.choice;
  choice.frame = std::move(frame);
  replace_choice(context, index, std::move(choice));
}

void remove_plot(ViewContext& context, int index) {
  std::vector<PlotChoice> choices = context.analysis.choices();
  choices.erase(choices.begin() + index);
  context.analysis.set_choices(std::move(choices));
  context.redraw = true;
}

}  // namespace

void draw_plot_buttons(ViewContext& context, const AnalysisPlot& plot, int index, ImVec2 at) {
  const bool pinned = !plot.choice.owner.empty();
  const float button = ImGui::GetFrameHeight();
  bool pins = false;
  std::optional<std::string> seen_from;
  if (can_be_pinned(plot)) {
    ImGui::SetCursorScreenPos({at.x - 2.0f * button, at.y});
    const char* tip = pinned ? "Follow the selection. The plot is of the selected joint again."
                             : "Keep this joint. The plot stays with it when another one is selected.";
    pins = ui::icon_button(context, SmallText("plots.pin.{}", index).c_str(), icons::kPin, tip, pinned);
  }
  if (can_be_seen_from(plot)) {
    ImGui::SetCursorScreenPos({at.x - 3.0f * button, at.y});
    if (ui::icon_button(context, SmallText("plots.frame.of.{}", index).c_str(), icons::kAxis3d,
                        "Frame of reference. Where the plot is seen from: the world, the root, any joint.", !plot.choice.frame.empty())) {
      ImGui::OpenPopup(kFrameList);
    }
    seen_from = draw_frame_list(context, plot);
  }
  ImGui::SetCursorScreenPos({at.x - button, at.y});
  const bool removes = ui::icon_button(context, SmallText("plots.remove.{}", index).c_str(), icons::kX, "Remove plot. It can be added again.");
  if (pins) toggle_pin(context, plot, index);
  else if (seen_from) see_from(context, plot, index, std::move(*seen_from));
  else if (removes) remove_plot(context, index);
}

void open_plot_menu() { ImGui::OpenPopup(kPlotMenu); }

void draw_plot_menu(ViewContext& context, const AnalysisPlot& plot, int index) {
  if (!ImGui::BeginPopup(kPlotMenu)) return;
  ui::popup_shadow(context);
  const ImVec2 spacing = ImGui::GetStyle().ItemSpacing;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {spacing.x, context.options.touch ? kTouchSpacing : spacing.y});
  const auto chosen = [&](const char* id, const char* label) {
    const bool is_chosen = ImGui::Selectable(label);
    context.items.add_last(id, label);
    return is_chosen;
  };
  const bool pins = can_be_pinned(plot) && chosen("plots.menu.pin", plot.choice.owner.empty() ? "Keep this joint" : "Follow the selection");
  const bool removes = chosen("plots.menu.remove", "Remove plot");
  std::string frame = plot.choice.frame;
  bool sees = false;
  if (can_be_seen_from(plot)) {
    ImGui::SeparatorText("Seen from");
    sees = draw_frames(context, plot, frame);
  }
  ImGui::PopStyleVar();
  ImGui::EndPopup();
  if (pins) toggle_pin(context, plot, index);
  else if (sees) see_from(context, plot, index, std::move(frame));
  else if (removes) remove_plot(context, index);
}

}  // namespace marey::app
