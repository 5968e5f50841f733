#include "wasm/views/curves/curves_toolbar.h"

#include <fmt/format.h>

#include "core/editing/curve_operations.h"
#include "wasm/app/widgets.h"
#include "wasm/views/number_edit.h"

namespace marey::app {
namespace {

bool has_selection(const ViewContext& context) { return !context.session.selection.samples().empty(); }

const char* common_unit(const ViewContext& context) {
  const Skeleton& skeleton = context.session.document.skeleton();
  const char* unit = nullptr;
  for (const SampleRun& run : context.session.selection.samples().runs()) {
    const char* own = unit_of(skeleton.channel(run.channel).kind);
    if (unit != nullptr && std::string_view(unit) != own) return "";
    unit = own;
  }
  return unit == nullptr ? "" : unit;
}

void label(ViewContext& context, std::string_view text) {
  ImGui::AlignTextToFramePadding();
  ui::dim_text(context, text);
  ImGui::SameLine(0.0f, 6.0f);
}

void separator(ViewContext& context) {
  ImGui::SameLine(0.0f, 10.0f);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  ImGui::GetWindowDrawList()->AddLine({at.x, at.y + 6.0f}, {at.x, at.y + height - 6.0f}, context.theme.line);
  ImGui::Dummy({1.0f, height});
  ImGui::SameLine(0.0f, 10.0f);
}

}  // namespace

// A selection may hold millions of samples: it is looked through when it or the clip has changed, not in each frame.
void CurvesToolbar::follow_selection(const ViewContext& context) {
  const SelectionFacts known = facts_;
  facts_.clip_serial = context.clip_serial;
  facts_.revision = context.session.document.revision();
  facts_.sample_serial = context.session.selection.sample_serial();
  const bool same = facts_.clip_serial == known.clip_serial && facts_.revision == known.revision &&
                    facts_.sample_serial == known.sample_serial && known.unit != nullptr;
  if (same) return;
  facts_.unit = common_unit(context);
  facts_.mean = compute_selection_mean(context.session.document.clip(), context.session.selection.samples());
}

void CurvesToolbar::draw_value(ViewContext& context) {
  const SampleSelection& selection = context.session.selection.samples();
  label(context, "Value");
  const auto result = ui::number_field(context, "curves.value", "Value", facts_.mean,
                                       {.unit = facts_.unit, .decimals = 3, .step = 0.1, .width = 104.0f});
  apply_number(context, result,
        [&](const Clip& clip) { return make_value_edit(clip, selection, result.value); });
}

void CurvesToolbar::draw_offset(ViewContext& context) {
  label(context, "Offset");
  const SampleSelection& selection = context.session.selection.samples();
  const auto result = ui::number_field(context, "curves.offset", "Offset", offset_,
                                       {.unit = facts_.unit, .decimals = 2, .step = 0.1, .width = 92.0f});
  apply_number(context, result, [&](const Clip& clip) { return make_move_edit(clip, selection, result.value, {}); });
  offset_ = result.event == ui::NumberEvent::Live ? result.value : 0.0;
}

void CurvesToolbar::draw_scale(ViewContext& context) {
  label(context, "Scale");
  const SampleSelection& selection = context.session.selection.samples();
  const auto result =
      ui::number_field(context, "curves.scale", "Scale", scale_, {.unit = "×", .decimals = 2, .step = 0.01, .width = 80.0f});
  apply_number(context, result, [&](const Clip& clip) {
    return make_scale_edit(clip, selection, result.value, compute_selection_mean(clip, selection));
  });
  scale_ = result.event == ui::NumberEvent::Live ? result.value : 1.0;
}

void CurvesToolbar::draw_smooth(ViewContext& context) {
  const auto sigma = ui::number_field(
      context, "curves.sigma", "Width", static_cast<double>(context.options.smooth_sigma_frames),
      {.unit = "frames", .decimals = 1, .step = 0.05, .low = 0.1, .high = 200.0, .width = 92.0f});
  if (sigma.event != ui::NumberEvent::None) context.options.smooth_sigma_frames = static_cast<float>(sigma.value);
  ImGui::SameLine(0.0f, 4.0f);
  ui::command_button(context, "curve.smooth", ui::ButtonLook::Raised, true);
}

float CurvesToolbar::height() { return ImGui::GetFrameHeight() + 8.0f; }

void CurvesToolbar::draw(ViewContext& context, CurvesState& /*state*/) {
  ui::command_button(context, "curve.fit");
  ImGui::SameLine(0.0f, 2.0f);
  ui::command_button(context, "curve.fit_selection");
  separator(context);
  label(context, "Falloff");
  const auto falloff = ui::number_field(
      context, "curves.falloff", "Falloff", static_cast<double>(context.options.falloff_radius_frames),
      {.unit = "frames", .decimals = 0, .step = 0.1, .low = 0.0, .high = 1000.0, .width = 88.0f});
  if (falloff.event != ui::NumberEvent::None) context.options.falloff_radius_frames = static_cast<float>(falloff.value);
  if (!has_selection(context)) {
    separator(context);
    constexpr const char* kAdvice = "Select samples to edit them";
    if (ImGui::CalcTextSize(kAdvice).x <= ImGui::GetContentRegionAvail().x) label(context, kAdvice);
    return ImGui::NewLine();
  }
  separator(context);
  follow_selection(context);
  draw_value(context);
  ImGui::SameLine(0.0f, 8.0f);
  draw_offset(context);
  ImGui::SameLine(0.0f, 8.0f);
  draw_scale(context);
  separator(context);
  draw_smooth(context);
}

}  // namespace marey::app
