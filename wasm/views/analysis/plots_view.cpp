#include "wasm/views/analysis/plots_view.h"

#include <algorithm>
#include <cmath>

#include "wasm/app/icons.h"
#include "wasm/app/widgets.h"
#include "wasm/views/analysis/clip_legend.h"
#include "wasm/views/analysis/plot_buttons.h"
#include "wasm/views/graph/small_plot.h"
#include "wasm/views/time_gutter.h"

namespace marey::app {
namespace {

constexpr float kLeastRowHeight = 64.0f;
constexpr float kContactsShare = 0.4f;  // of the panel, at most
constexpr float kLabelInset = 12.0f;
constexpr float kLeastPlotWidth = 200.0f;
constexpr const char* kAddList = "plots.add.list";
constexpr float kTouchHeight = 32.0f;

std::span<const ui::ChoiceOption> mode_options() {
  static const std::vector<ui::ChoiceOption> kOptions = {{"plots.mode.time", "Over time"},
                                                         {"plots.mode.against", "Against the first"},
                                                         {"plots.mode.statistics", "Statistics"}};
  return kOptions;
}

void draw_text(ViewContext& context, ImFont* font, ImVec2 at, float width, ImU32 color, std::string_view text) {
  ImGui::SetCursorScreenPos(at);
  ImGui::PushFont(font, Fonts::kTextSize);
  ui::elided_text(context, text, width, color);
  ImGui::PopFont();
}

// For people: "Smoothed by Butterworth, 6 Hz."
SmallText describe_smoothing(const Derivation& derivation) {
  switch (derivation.kind) {
    case DerivationKind::Central: break;
    case DerivationKind::Butterworth: return SmallText("Smoothed by Butterworth, {:g} Hz.", derivation.cutoff_hz);
    case DerivationKind::SavitzkyGolay:
      return SmallText("Smoothed by Savitzky-Golay, {} frames, degree {}.", derivation.window, derivation.degree);
    case DerivationKind::Gcv: return SmallText("Smoothed by a quintic spline (GCV).");
    case DerivationKind::Spline:
      return SmallText("Smoothed by a quintic spline, noise {:g}° and {:g} mm.", derivation.noise_deg, derivation.noise_mm);
  }
  return SmallText("Not smoothed.");
}

// A component belongs to that of the same direction; one without direction to the one that changes most.
const PlotLine& partner_of(const PlotLine& line, const std::vector<PlotLine>& first) {
  const PlotLine* widest = &first.front();
  double most = -1.0;
  for (const PlotLine& along : first) {
    if (along.component == line.component) return along;
    ValueRange range;
    range.add(along.values);
    if (!range.empty && range.high - range.low > most) widest = &along;
    if (!range.empty) most = std::max(most, range.high - range.low);
  }
  return *widest;
}

// Of the clips beside the open one first, so that they lie behind.
std::vector<PlotCurve> curves_against(const ViewContext& context, const AnalysisPlot& plot, const AnalysisPlot& first) {
  std::vector<PlotCurve> curves;
  for (std::size_t other = 0; other < std::min(plot.others.size(), first.others.size()); ++other) {
    if (first.others[other].lines.empty()) continue;
    for (const PlotLine& line : plot.others[other].lines) {
      const PlotLine& along = partner_of(line, first.others[other].lines);
      curves.push_back({along.values, line.values, with_alpha(component_color(context.theme, line.component), 0.8f), 1.25f, dashes_of(other)});
    }
  }
  for (const PlotLine& line : plot.lines) {
    curves.push_back({partner_of(line, first.lines).values, line.values, component_color(context.theme, line.component), 1.5f});
  }
  return curves;
}

const char* why_nothing(const ViewContext& context) {
  return context.session.is_partial ? "The file is still being read." : "Nothing is plotted. Add a plot.";
}

}  // namespace

const Quantity* draw_quantity_list(ViewContext& context, const char* popup) {
  const Quantity* chosen = nullptr;
  if (!ImGui::BeginPopup(popup)) return nullptr;
  ui::popup_shadow(context);
  for (const Quantity& quantity : quantities()) {
    const SmallText label("{} [{}]", quantity.label, shown_unit(quantity.unit));
    if (ImGui::Selectable(label.c_str())) chosen = &quantity;
    context.items.add_last(SmallText("plots.add.{}", quantity.name), label);
  }
  ImGui::EndPopup();
  return chosen;
}

void PlotsView::draw_add(ViewContext& context) {
  if (ui::text_button(context, "plots.add", "Add plot", "Plots another quantity, of the selected joint where it is of a joint.")) {
    ImGui::OpenPopup(kAddList);
  }
  const Quantity* chosen = draw_quantity_list(context, kAddList);
  if (chosen == nullptr) return;
  std::vector<PlotChoice> choices = context.analysis.choices();
  choices.push_back({chosen, {}});
  context.analysis.set_choices(std::move(choices));
  context.redraw = true;
}

void PlotsView::draw_toolbar(ViewContext& context, ImVec2 min, float width) {
  ImGui::SetCursorScreenPos({min.x + kLabelInset, min.y + 4.0f});
  ImGui::BeginChild("plots.toolbar", {width - kLabelInset, ImGui::GetFrameHeight() + 4.0f}, ImGuiChildFlags_None, ImGuiWindowFlags_NoScrollbar);
  draw_add(context);
  ImGui::SameLine(0.0f, 8.0f);
  int mode = static_cast<int>(context.options.plot_mode);
  if (ui::choice(context, "plots.mode", "Show", "Curves over time, curves against the first one, or statistics of the range.", mode_options(),
                 mode, context.options.compact ? 112.0f : 148.0f)) {
    context.options.plot_mode = static_cast<PlotMode>(mode);
  }
  for (const char* id : {"analysis.body", "analysis.save_csv", "analysis.save_svg", "analysis.save_png"}) {
    ImGui::SameLine(0.0f, 4.0f);
    ui::command_button(context, id);
  }
  ImGui::SameLine(0.0f, 12.0f);
  ImGui::AlignTextToFramePadding();
  const std::vector<std::string>& notes = context.analysis.notes();
  const SmallText text("{}{}{}", describe_smoothing(context.analysis.derivation).view(), notes.empty() ? "" : " ",
                       notes.empty() ? std::string_view() : std::string_view(notes.back()));
  ui::elided_text(context, text, ImGui::GetContentRegionAvail().x - 8.0f, context.theme.dim_text);
  context.items.add_last("plots.method", text);
  ImGui::EndChild();
}

void PlotsView::draw_label(ViewContext& context, const AnalysisPlot& plot, int index, ImVec2 min, ImVec2 max) {
  const float width = max.x - min.x - kLabelInset;
  const float button = ImGui::GetFrameHeight();
  const ImVec2 at{min.x + kLabelInset, min.y + 6.0f};
  const Theme& theme = context.theme;
  draw_text(context, context.fonts.semibold, at, width, theme.text, plot.choice.quantity->label);
  const float line = std::round(at.y + 18.0f);
  const SmallText owner("{}", plot.problem.empty() ? plot.whose() : plot.problem);
  const SmallText unit("  {}", plot.unit);
  const float unit_width = ImGui::CalcTextSize(unit.c_str()).x;
  const float owner_width = width - 3.0f * button - unit_width;
  draw_text(context, context.fonts.text, {at.x, line}, owner_width, plot.problem.empty() ? theme.dim_text : theme.warning, owner);
  const float shown_width = std::min(ImGui::CalcTextSize(owner.c_str()).x, owner_width);
  ImGui::GetWindowDrawList()->AddText({at.x + shown_width, line}, theme.dim_text, unit.c_str());
  draw_plot_buttons(context, plot, index, {max.x, std::round(line + 9.0f - 0.5f * button)});
  draw_values(context, plot, index, {at.x, line + 20.0f}, max);
}

// Within the plot, on a veil: a narrow page has no room beside it.
void PlotsView::draw_narrow_label(ViewContext& context, const AnalysisPlot& plot, int index, ImVec2 min, ImVec2 max) const {
  const SmallText title("{}, {} [{}]", plot.choice.quantity->label, plot.whose(), plot.unit);
  const ImVec2 at{min.x + 4.0f, min.y + 8.0f};
  const float width = std::min(ImGui::CalcTextSize(title.c_str()).x, max.x - at.x);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 veil = with_alpha(context.theme.panel, 0.75f);
  list.AddRectFilled({at.x - 3.0f, at.y}, {at.x + width + 3.0f, at.y + 17.0f}, veil, 3.0f);
  ImGui::PushFont(context.fonts.text, Fonts::kSmallSize + 1.0f);
  ImGui::SetCursorScreenPos({at.x, at.y + 1.0f});
  ui::elided_text(context, title, max.x - at.x, context.theme.text);
  ImGui::PopFont();
  const SmallText id("plots.menu.{}", index);
  ImGui::SetCursorScreenPos({at.x - 3.0f, min.y});
  if (ImGui::InvisibleButton(id.c_str(), {width + 6.0f, kTouchHeight})) open_plot_menu();
  context.items.add_last(id, title);
  draw_plot_menu(context, plot, index);
  const float bottom = max.y - 22.0f;
  list.AddRectFilled({at.x - 3.0f, bottom}, {max.x, bottom + 14.0f}, veil, 3.0f);
  draw_values(context, plot, index, {at.x, bottom + 1.0f}, {max.x, max.y});
}

// One below the other where there is room, else side by side.
void PlotsView::draw_values(ViewContext& context, const AnalysisPlot& plot, int index, ImVec2 at, ImVec2 max) const {
  constexpr float kLine = 15.0f;
  const FrameIndex frame = context.session.playback.frame();
  const bool in_one_row = max.y - at.y < 3.0f * kLine + 3.0f;
  const ImVec2 step = in_one_row ? ImVec2((max.x - at.x) / 3.0f, 0.0f) : ImVec2(0.0f, kLine);
  for (const PlotLine& line : plot.lines) {
    if (at.y + 12.0f > max.y) return;
    const double value = frame < size_of(line.values) ? line.values[idx(frame)] : std::nan("");
    const char letter[] = {static_cast<char>(line.component == 0 ? 'n' : line.component - 'x' + 'X'), '\0'};
    const SmallText text("{} {}", line.component == 0 ? "" : letter, value_text(value).view());
    ImGui::GetWindowDrawList()->AddText(context.fonts.mono, Fonts::kSmallSize, {std::round(at.x), std::round(at.y)},
                                        component_color(context.theme, line.component), text.c_str());
    context.items.add(SmallText("plots.value.{}.{}", index, letter), value_text(value), at, {at.x + 50.0f, at.y + 12.0f});
    at = {at.x + step.x, at.y + step.y};
  }
}

void PlotsView::draw_rows(ViewContext& context, ImVec2 min, ImVec2 max) {
  const std::span<const AnalysisPlot> plots = context.analysis.plots();
  rows_.resize(plots.size());
  ImGui::SetCursorScreenPos(min);
  ImGui::BeginChild("plots.rows", {max.x - min.x, max.y - min.y}, ImGuiChildFlags_None, ImGuiWindowFlags_NoScrollWithMouse);
  const float count = static_cast<float>(std::max<std::size_t>(plots.size(), 1));
  const float height = std::max(kLeastRowHeight, std::floor((max.y - min.y) / count));
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  for (std::size_t i = 0; i < plots.size(); ++i) {
    const float top = corner.y + static_cast<float>(i) * height;
    ImGui::PushID(static_cast<int>(i));
    rows_[i].draw(context, plots[i], context.analysis.serial(), static_cast<int>(i), {min.x, top}, {max.x, top + height});
    if (context.options.compact) {
      draw_narrow_label(context, plots[i], static_cast<int>(i), {context.time_window.left, top}, {context.time_window.right - 40.0f, top + height});
    } else {
      draw_label(context, plots[i], static_cast<int>(i), {min.x, top}, {min.x + kChannelListWidth, top + height});
    }
    if (i > 0) ImGui::GetWindowDrawList()->AddLine({min.x, top}, {max.x, top}, context.theme.line);
    ImGui::PopID();
  }
  ImGui::SetCursorScreenPos(corner);
  ImGui::Dummy({1.0f, height * static_cast<float>(plots.size()) - 1.0f});
  ImGui::EndChild();
}

void PlotsView::draw_against(ViewContext& context, ImVec2 min, ImVec2 max) const {
  const std::span<const AnalysisPlot> plots = context.analysis.plots();
  if (plots.size() < 2 || plots[0].lines.empty()) {
    ImGui::SetCursorScreenPos({min.x + kLabelInset, min.y + kLabelInset});
    ui::dim_text(context, plots.size() < 2 ? "Add a second plot to see it against the first." : "The first plot has no curves.");
    return;
  }
  ValueRange range;
  for (const PlotLine& line : plots[0].lines) range.add(line.values);
  for (const OtherLines& other : plots[0].others) {
    for (const PlotLine& line : other.lines) range.add(line.values);
  }
  const double margin = 0.04 * std::max(range.high - range.low, 1e-9);
  const FrameIndex frame = context.session.playback.frame();
  const SmallText x_unit("{} {}", plots[0].choice.quantity->label, plots[0].unit);
  for (int i = 1; i < size_of(plots); ++i) {
    const std::vector<PlotCurve> curves = curves_against(context, plots[idx(i)], plots[0]);
    std::vector<PlotDot> dots;
    for (const PlotLine& line : plots[idx(i)].lines) {
      const PlotLine& along = partner_of(line, plots[0].lines);
      const ImU32 color = component_color(context.theme, line.component);
      if (idx(frame) < std::min(along.values.size(), line.values.size())) dots.push_back({along.values[idx(frame)], line.values[idx(frame)], color});
    }
    const ImVec4 place = plot_place(i - 1, size_of(plots) - 1, {min.x + 4.0f, min.y}, max, kLeastPlotWidth);
    const std::string title = plots[idx(i)].title();
    draw_small_plot(context, SmallText("plots.against.{}", i).c_str(), {place.x, place.y}, {place.z, place.w},
                    {title, x_unit, "", range.low - margin, range.high + margin, curves, {}, {}, false, dots, kLeastHeight});
  }
}

void follow_analysis(ViewContext& context) {
  const bool waits = context.analysis.follow(context.session, context.clip_serial, context.options.curves_page == CurvesPage::Plots,
                                             context.options.shown_arrows, ImGui::IsMouseDown(ImGuiMouseButton_Left));
  context.redraw = context.redraw || waits;
}

void PlotsView::draw(ViewContext& context, ImVec2 min, ImVec2 max, float pages_width) {
  follow_analysis(context);
  draw_toolbar(context, min, max.x - min.x - pages_width);
  ImVec2 top{min.x, min.y + ImGui::GetFrameHeight() + 10.0f};
  if (max.y - top.y < 40.0f) return;
  if (!context.analysis.problem().empty() || context.analysis.plots().empty()) {
    ImGui::SetCursorScreenPos({top.x + kLabelInset, top.y + kLabelInset});
    const std::string& problem = context.analysis.problem();
    ui::elided_text(context, problem.empty() ? why_nothing(context) : problem, max.x - min.x - 2.0f * kLabelInset,
                    problem.empty() ? context.theme.dim_text : context.theme.warning);
    context.items.add_last("plots.problem", problem);
    return;
  }
  top.y += draw_clip_legend(context, top, max.x - min.x);
  if (max.y - top.y < kLeastRowHeight) return;
  switch (context.options.plot_mode) {
    case PlotMode::OverTime: {
      const float height = contacts_.draw(context, top, {max.x, top.y + kContactsShare * (max.y - top.y)});
      draw_rows(context, {top.x, top.y + height}, max);
      break;
    }
    case PlotMode::AgainstFirst: draw_against(context, top, max); break;
    case PlotMode::Statistics: draw_statistics(context, top, max); break;
  }
}

}  // namespace marey::app
