#include "wasm/views/analysis/body_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/biomechanics/own_segments.h"
#include "core/editing/clip_operations.h"
#include "core/signal/residual_analysis.h"
#include "wasm/app/widgets.h"
#include "wasm/views/analysis/segment_rows.h"
#include "wasm/views/inspector/clip_page.h"
#include "wasm/views/inspector/property_row.h"
#include "wasm/views/number_edit.h"

namespace marey::app {
namespace {

using Options = std::span<const ui::ChoiceOption>;

Options table_options() {
  static const std::vector<ui::ChoiceOption> kOptions = {{"body.table.auto", "By joint names"},
                                                         {"body.table.male", "de Leva 1996, male"},
                                                         {"body.table.female", "de Leva 1996, female"},
                                                         {"body.table.winter", "Winter 2009"},
                                                         {"body.table.rods", "Uniform rods"},
                                                         {"body.table.own", "Own values"}};
  return kOptions;
}

Options support_options() {
  static const std::vector<ui::ChoiceOption> kOptions = {{"body.support.pivot", "A bar at the root"},
                                                         {"body.support.flight", "Nothing: in flight"},
                                                         {"body.support.ground", "The ground"},
                                                         {"body.support.auto", "As the motion tells"}};
  return kOptions;
}

Options derivation_options() {
  static const std::vector<ui::ChoiceOption> kOptions = {{"body.derivation.central", "As it is"},
                                                         {"body.derivation.butterworth", "Butterworth"},
                                                         {"body.derivation.savgol", "Savitzky-Golay"},
                                                         {"body.derivation.gcv", "Quintic spline, GCV"},
                                                         {"body.derivation.spline", "Quintic spline, known noise"}};
  return kOptions;
}

// Own values begin with those that the body has.
BodyChoice without_table(const Clip& clip) {
  const Result<ChosenBody> body = find_chosen_body(clip);
  if (body) return choose_model(clip.body, body->body.model);
  BodyChoice choice = clip.body;
  choice.is_only_own = true;
  std::erase_if(choice.segments, [](const OwnSegment& own) { return !own.shape; });
  return choice;
}

void draw_table(ViewContext& context) {
  const Clip& clip = context.session.document.clip();
  const int own = size_of(table_options()) - 1;
  const float width = inspector::begin_row(context, "Table");
  const int present = clip.body.is_only_own ? own : clip.body.table ? static_cast<int>(*clip.body.table) + 1 : 0;
  int chosen = present;
  if (ui::choice(context, "body.table", "Table", "Where the masses of the segments come from.", table_options(), chosen, width) && chosen != present) {
    BodyChoice body = chosen == own ? without_table(clip) : clip.body;
    if (present == own) body.segments.clear();
    body.is_only_own = chosen == own;
    body.table = chosen == 0 || chosen == own ? std::nullopt : std::optional(static_cast<BodyTable>(chosen - 1));
    apply_body(context, body);
  }
  inspector::end_row();
}

void draw_mass(ViewContext& context, double mass_kg) {
  const float width = inspector::begin_row(context, "Mass");
  const auto result = ui::number_field(context, "body.mass", "Mass of the body; the segments keep their shares", mass_kg,
                                       {.unit = "kg", .decimals = 1, .step = 0.1, .low = 0.001, .high = 1e4, .width = width});
  apply_number(context, result, [&](const Clip& clip) { return make_body_edit(clip, with_body_mass(clip, result.value)); });
  inspector::end_row();
}

void draw_gravity(ViewContext& context) {
  const Clip& present = context.session.document.clip();
  const glm::dvec3 gravity = find_gravity(present.body.gravity_mps2, present.settings.up_axis);
  const float width = inspector::begin_row(context, "Gravity");
  const auto result = ui::number_field(context, "body.gravity", "Gravity: 9.81 on Earth, 1.62 on the Moon, 0 in free fall", glm::length(gravity),
                                       {.unit = "m/s²", .decimals = 2, .step = 0.01, .low = 0.0, .high = 1000.0, .width = width});
  apply_number(context, result, [&](const Clip& clip) {
    BodyChoice body = clip.body;
    const glm::dvec3 usual = find_gravity({}, clip.settings.up_axis);
    const glm::dvec3 before = find_gravity(body.gravity_mps2, clip.settings.up_axis);
    const glm::dvec3& down = glm::length(before) > 0.0 ? before : usual;
    body.gravity_mps2 = result.value * (down / glm::length(down));
    if (*body.gravity_mps2 == usual) body.gravity_mps2.reset();
    return make_body_edit(clip, body);
  });
  inspector::end_row();
}

void draw_notes(ViewContext& context, std::span<const std::string> notes) {
  for (const std::string& note : notes) {
    ImGui::SetCursorPosX(inspector::kPadding);
    ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - inspector::kPadding);
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.dim_text);
    ImGui::TextUnformatted(note.c_str());
    context.items.add_last("body.note", note);
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0.0f, 4.0f});
  }
}

void draw_support(ViewContext& context) {
  inspector::heading(context, "What holds it");
  const float width = inspector::begin_row(context, "Support");
  int chosen = static_cast<int>(context.analysis.support);
  if (ui::choice(context, "body.support", "Support", "What the body hangs on or stands on.", support_options(), chosen, width)) {
    context.analysis.support = static_cast<SupportKind>(chosen);
  }
  inspector::end_row();
}

void draw_number(ViewContext& context, const char* id, const char* name, double& value, const ui::NumberFormat& format) {
  ui::NumberFormat fitted = format;
  fitted.width = inspector::begin_row(context, name);
  const auto result = ui::number_field(context, id, name, value, fitted);
  if (result.event != ui::NumberEvent::None) value = result.value;
  inspector::end_row();
}

// The middle one of what the residuals of the joint's rotations suggest; 0 where they suggest nothing.
double suggested_cutoff_hz(const Clip& clip, JointIndex joint) {
  std::vector<double> found;
  for (int i = 0; joint != kNoParent && i < clip.skeleton.channel_count(joint); ++i) {
    const ChannelIndex channel = clip.skeleton.first_channel(joint) + i;
    if (!is_rotation(clip.skeleton.channel(channel).kind)) continue;
    const double cutoff_hz = analyse_residuals(clip.motion.channel_samples(channel), 1.0 / clip.motion.frame_time_s()).cutoff_hz;
    if (cutoff_hz > 0.0) found.push_back(cutoff_hz);
  }
  std::sort(found.begin(), found.end());
  return found.empty() ? 0.0 : found[found.size() / 2];
}

void draw_suggestion(ViewContext& context, Derivation& derivation) {
  inspector::begin_row(context, "");
  if (ui::text_button(context, "body.cutoff.suggest", "Suggest", "Takes the cut-off that the residuals of the plotted joint suggest (Winter 2009).")) {
    const double cutoff_hz = suggested_cutoff_hz(context.session.document.clip(), find_plotted_joint(context.session));
    if (cutoff_hz > 0.0) derivation.cutoff_hz = std::round(10.0 * cutoff_hz) / 10.0;
    else context.refusal = "The residuals of this joint suggest no cut-off.";
  }
  inspector::end_row();
}

void draw_derivation(ViewContext& context) {
  Derivation& derivation = context.analysis.derivation;
  inspector::heading(context, "Velocities and accelerations");
  const float width = inspector::begin_row(context, "Smoothing");
  int chosen = static_cast<int>(derivation.kind);
  if (ui::choice(context, "body.derivation", "Smoothing", "What is done to samples before they are differentiated.", derivation_options(), chosen,
                 width)) {
    derivation.kind = static_cast<DerivationKind>(chosen);
  }
  inspector::end_row();
  if (derivation.kind == DerivationKind::Butterworth) {
    draw_number(context, "body.cutoff", "Cut-off", derivation.cutoff_hz, {.unit = "Hz", .decimals = 1, .step = 0.1, .low = 0.1, .high = 1000.0});
    draw_suggestion(context, derivation);
  } else if (derivation.kind == DerivationKind::SavitzkyGolay) {
    double window = derivation.window;
    double degree = derivation.degree;
    draw_number(context, "body.window", "Window", window, {.unit = "frames", .decimals = 0, .step = 2.0, .low = 3.0, .high = 301.0});
    draw_number(context, "body.degree", "Degree", degree, {.unit = "", .decimals = 0, .step = 0.1, .low = 2.0, .high = 8.0});
    derivation.window = static_cast<int>(window) / 2 * 2 + 1;
    derivation.degree = std::min(static_cast<int>(degree), derivation.window - 1);
  } else if (derivation.kind == DerivationKind::Spline) {
    draw_number(context, "body.noise.angles", "Noise, angles", derivation.noise_deg, {.unit = "°", .decimals = 2, .step = 0.01, .low = 0.001, .high = 90.0});
    draw_number(context, "body.noise.places", "Noise, places", derivation.noise_mm, {.unit = "mm", .decimals = 1, .step = 0.1, .low = 0.001, .high = 1e4});
  }
  ImGui::SetCursorPosX(inspector::kPadding);
  ui::toggle(context, "body.bands", "Bands of doubt",
             "Shows how far each curve moves with another cut-off, another table of the body, and a unit of length 2 % off.",
             context.analysis.shows_bands);
  inspector::end_row();
  if (derivation.kind == DerivationKind::Central) return;
  ImGui::SetCursorPosX(inspector::kPadding);
  ui::toggle(context, "body.raw", "Without smoothing too", "Draws the unsmoothed curve in grey behind the smoothed one.", context.analysis.shows_raw);
  inspector::end_row();
}

}  // namespace

void draw_body_page(ViewContext& context) {
  const Clip& clip = context.session.document.clip();
  if (clip.skeleton.joint_count() == 0) return;
  draw_derivation(context);
  draw_support(context);
  if (context.analysis.is_of(context.clip_serial)) draw_notes(context, context.analysis.notes());
  const std::vector<std::string>& judgement = context.analysis.judgement(context.session, context.clip_serial);
  if (!judgement.empty()) inspector::heading(context, "Does it make sense?");
  draw_notes(context, judgement);
  inspector::heading(context, "Body");
  draw_table(context);
  inspector::draw_unit(context);
  context.analysis.follow_body(context.session, context.clip_serial);
  const ChosenBody* body = context.analysis.body();
  if (body == nullptr) {
    draw_notes(context, std::span(&context.analysis.body_problem(), 1));
  } else {
    draw_mass(context, body->mass_kg);
    draw_notes(context, body->body.notes);
  }
  draw_gravity(context);
  draw_model_buttons(context);
  draw_carried_segment(context);
  if (body != nullptr) draw_segment_list(context, *body);
  ImGui::Dummy({0.0f, 16.0f});
}

}  // namespace marey::app
